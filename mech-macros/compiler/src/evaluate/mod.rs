//! Runs a program now: for the studio, and to check the generated code against.

mod beside;
mod journey;
mod run;

pub use run::Prepared;

use crate::bug::bug;
use crate::program::{
    BlockId, Forces, LinkRates, Op, ParamRates, Position, Program, Timing, Value,
};
use journey::Move;
use mech_core::journey::Halt;
use mech_core::{Phase, Real};
use run::{MotionInputs, Runner};

/// Why a mechanism did not go to a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// There are not as many values as motors (and params, if these are given).
    MotorCount,
    /// The value for this motor, or for a param by its number after the motors, is not a finite number.
    NotFinite(usize),
    /// The loop of this block does not close.
    Open(BlockId),
    /// The loop of this block would pass a dead point.
    DeadPoint(BlockId),
    /// The loop of this block is at a change point and was declared to stop there.
    ChangePoint(BlockId),
    /// The displacement is too long for one move.
    TooFar,
    /// A coordinate is beyond the range of the numbers.
    Overflow,
    /// The rates of the loop with this number are not determined: it is at a dead point or a change point.
    Singular(usize),
    /// The program does not compute rates.
    Unasked,
}

/// A mechanism that is moved by interpretation, in any precision, whatever the program was compiled for.
#[derive(Clone, Debug)]
pub struct Machine<'p, T: Real> {
    runner: Runner<'p, T>,
    position: Position<T>,
}

impl<'p, T: Real> Machine<'p, T> {
    /// The mechanism as it was assembled.
    #[must_use]
    pub fn new(program: &'p Program) -> Self {
        let start = &program.start;
        let position = Position { turns: vec![0; start.motors.len()], ..start.map(T::from_f64) };
        Self { runner: Runner::new(program), position }
    }

    /// The mechanism at a position that it had before. The program is the one that was prepared.
    #[must_use]
    pub fn at(program: &'p Program, prepared: &'p Prepared<T>, position: Position<T>) -> Self {
        Self { runner: Runner::of(program, prepared), position }
    }

    /// Its position; the machine is done with.
    #[must_use]
    pub fn into_position(self) -> Position<T> {
        self.position
    }

    /// Its position.
    #[must_use]
    pub fn position(&self) -> &Position<T> {
        &self.position
    }

    /// Puts it where it was.
    pub fn put_back(&mut self, position: Position<T>) {
        self.position = position;
    }

    /// Allows so many operations from now on. A move that needs more stops where it then is, as if the target were too far.
    pub(crate) fn allow(&mut self, operations: usize) {
        self.runner.left.set(operations);
    }

    /// Returns the number of operations that it may still make.
    pub(crate) fn left(&self) -> usize {
        self.runner.left.get()
    }

    /// Goes there in one step, whatever lies between. The mechanism stays where it was if a loop does not close there.
    pub(crate) fn leap(&mut self, motors: &[T]) -> Result<(), Stop> {
        self.position = self.leaped(&self.position, motors)?;
        Ok(())
    }

    /// The same from another position.
    pub(crate) fn leap_from(&mut self, last: &Position<T>, motors: &[T]) -> Result<(), Stop> {
        self.position = self.leaped(last, motors)?;
        Ok(())
    }

    fn leaped(&self, last: &Position<T>, motors: &[T]) -> Result<Position<T>, Stop> {
        Move::new(&self.runner, last, motors, &last.turns).leap()
    }

    /// Gives the motors these values, one for each in order of declaration, in radians or scene units. The values of all params may
    /// follow; else these stay as they are.
    ///
    /// # Errors
    /// The reason why it cannot go there; it then stays where it was.
    pub fn move_to(&mut self, motors: &[T]) -> Result<(), Stop> {
        self.advance(motors, &vec![0; motors.len()]).map_err(|halt| halt.stop)
    }

    /// Gives the params these values, one for each in order of declaration; the motors stay where they are.
    ///
    /// # Errors
    /// The reason why it cannot be assembled so by a continuous change from where it is; it then stays where it was.
    pub fn set_params(&mut self, params: &[T]) -> Result<(), Stop> {
        let mut inputs = self.position.motors.clone();
        let motors = self.runner.program.motors.len();
        if params.len() != inputs.len() - motors {
            return Err(Stop::MotorCount);
        }
        inputs.truncate(motors);
        inputs.extend_from_slice(params);
        let turns = self.position.turns.clone();
        self.advance(&inputs, &turns).map_err(|halt| halt.stop)
    }

    /// The values of the params, in order of declaration.
    #[must_use]
    pub fn params(&self) -> &[T] {
        &self.position.motors[self.runner.program.motors.len()..]
    }

    /// Gives the motors these phases; all of them have to turn.
    ///
    /// # Errors
    /// The reason why it cannot go there; it then stays where it was.
    pub fn turn_to(&mut self, phases: &[Phase]) -> Result<(), Stop> {
        let split = phases.iter().map(|phase| T::of_phase(*phase));
        let (turns, motors): (Vec<i64>, Vec<T>) = split.unzip();
        let turns: Option<Vec<i32>> =
            turns.into_iter().map(|turns| turns.try_into().ok()).collect();
        self.advance(&motors, &turns.ok_or(Stop::Overflow)?).map_err(|halt| halt.stop)
    }

    /// Moves towards these values of the motors as far as it can. Gives the reason if it does not arrive.
    ///
    /// # Errors
    /// If there are too few or too many values, or one is not finite; it then stays where it was.
    pub fn move_toward(&mut self, motors: &[T]) -> Result<Option<Stop>, Stop> {
        match self.advance(motors, &vec![0; motors.len()]) {
            Ok(()) => Ok(None),
            Err(Halt { stop: stop @ (Stop::MotorCount | Stop::NotFinite(_)), .. }) => Err(stop),
            Err(halt) => {
                self.position = halt.position;
                Ok(Some(halt.stop))
            }
        }
    }

    /// The rates of all links where it is, if the motors move at these rates and second rates: at a change point that it passes, their
    /// limit.
    ///
    /// # Errors
    /// If a loop is at a dead point, where rates are not determined; if a rate is not finite; or if the
    /// program does not compute rates.
    pub fn motion(&self, rates: &[T], accelerations: &[T]) -> Result<LinkRates<T>, Stop> {
        let given = self.given(rates, accelerations, &[])?;
        beside::limit(&self.runner, &self.position, |at| self.runner.motion(at, given))
    }

    /// The forces where it is, if the motors move at these rates and second rates, and the loads are these numbers: at a
    /// change point that it passes, their limit.
    ///
    /// # Errors
    /// If a loop is at a dead point, or at a change point where forces grow without bound; if a number is not finite or missing; or if
    /// the program does not compute forces.
    pub fn forces(&self, rates: &[T], accelerations: &[T], loads: &[T]) -> Result<Forces<T>, Stop> {
        let given = self.given(rates, accelerations, loads)?;
        beside::limit(&self.runner, &self.position, |at| self.runner.forces(at, given))
    }

    fn given<'g>(
        &self,
        rates: &'g [T],
        accelerations: &'g [T],
        loads: &'g [T],
    ) -> Result<MotionInputs<'g, T>, Stop> {
        let count = self.runner.program.motors.len();
        if rates.len() != count || accelerations.len() != count {
            return Err(Stop::MotorCount);
        }
        let finite = |(rate, second): (&T, &T)| rate.is_finite() && second.is_finite();
        if let Some(motor) = rates.iter().zip(accelerations).position(|both| !finite(both)) {
            return Err(Stop::NotFinite(motor));
        }
        if loads.iter().any(|load| !load.is_finite()) {
            return Err(Stop::Overflow);
        }
        Ok(MotionInputs { rates, accelerations, loads })
    }

    /// Runs the program once for these values of motors and params, without looking at the way there.
    ///
    /// # Errors
    /// The loop that does not close; it then stays where it was.
    pub(crate) fn step_to(&mut self, inputs: &[T]) -> Result<(), Stop> {
        let position = &self.position;
        self.position = self.runner.step(position, (inputs, &position.turns))?;
        Ok(())
    }

    /// Numbers of the program at these values of motors and params, even where loops in closed form are open. Where all close, it
    /// goes there in one step.
    pub(crate) fn look_at(&mut self, inputs: &[T], wanted: &[Value]) -> Option<Vec<T>> {
        let zero = vec![T::ZERO; inputs.len()];
        let given = MotionInputs { rates: &zero, accelerations: &zero, loads: &[] };
        let goal = (inputs, &self.position.turns[..]);
        let values = self.runner.values_even_if_open(&self.position, goal, given);
        let values = values.ok()?;
        if self.runner.open(&values).is_none() {
            self.position = self.runner.position(&values, goal).ok()?;
        }
        Some(wanted.iter().map(|value| values[value.index()]).collect())
    }

    /// Gives the motors, and params after them, these values, with whole turns beside them, exactly as the generated code's runtime does
    /// it.
    ///
    /// # Errors
    /// How far it would have come, and what stops it.
    pub(crate) fn advance(
        &mut self,
        motors: &[T],
        turns: &[i32],
    ) -> Result<(), Halt<Position<T>, Stop, T>> {
        let refuse = |stop| Halt { position: self.position.clone(), part: T::ZERO, stop };
        let (all, own) = (self.position.motors.len(), self.runner.program.motors.len());
        if motors.len() != all && motors.len() != own || turns.len() != motors.len() {
            return Err(refuse(Stop::MotorCount));
        }
        let params = &self.position.motors[motors.len()..];
        let motors = &[motors, params].concat()[..];
        let turns = &[turns, &vec![0; params.len()]].concat()[..];
        if let Some(motor) = motors.iter().position(|value| !value.is_finite()) {
            return Err(refuse(Stop::NotFinite(motor)));
        }
        let goal = Move::new(&self.runner, &self.position, motors, turns);
        self.position = goal.run()?;
        Ok(())
    }
}

/// Lets the program itself close the loops of its start, so that the assembled position is as exact as any later one.
///
/// # Errors
/// The loop that does not close.
pub fn settle(program: &mut Program) -> Result<(), Stop> {
    let mut machine = Machine::<f64>::new(program);
    let inputs = machine.position.motors.clone();
    machine.step_to(&inputs)?;
    let mut start = machine.into_position();
    // A zero of generated code has no sign.
    let numbers = start.poses.as_flattened_mut().iter_mut();
    for number in numbers.chain(&mut start.state) {
        *number += 0.0;
    }
    program.start = start;
    Ok(())
}

/// The rates of everything with each param at a position, by the program that computes them.
///
/// # Errors
/// If a loop is at a dead point or a change point, where that is not determined, or if the program does not compute it.
pub fn sensitivities<T: Real>(
    program: &Program,
    at: &Position<T>,
) -> Result<Vec<ParamRates<T>>, Stop> {
    let sensitivity = program.sensitivity().ok_or(Stop::Unasked)?;
    let given = MotionInputs { rates: &[], accelerations: &[], loads: &[] };
    let values = Runner::new(program).determined_values(at, given)?;
    let rates = sensitivity.of_params.iter();
    let rates: Vec<ParamRates<T>> =
        rates.map(|rates| rates.map(|value: Value| values[value.index()])).collect();
    let is_finite = |rates: &ParamRates<T>| rates.roots().all(Real::is_finite);
    if rates.iter().all(is_finite) { Ok(rates) } else { Err(Stop::Overflow) }
}

impl Timing {
    /// For each motor that has a law its value, its rate and its second rate at a time and with these params, as far as they were
    /// asked for, else zero: the same bits as the generated code.
    #[must_use]
    pub fn at(&self, time: f64, params: &[f64]) -> Vec<[f64; 3]> {
        let program = &self.program;
        let mut values = vec![0.0; program.ssa.nodes.len()];
        for (param, value) in self.used_params() {
            values[value.index()] = params[param.index()];
        }
        for value in program.live_values() {
            let op = program.node(value).op;
            if matches!(op, Op::Input(_)) {
                // A param, which is known.
                continue;
            }
            let found = match op {
                Op::Time => Some(time),
                op => op.apply(|value: Value| values[value.index()]),
            };
            values[value.index()] = found.unwrap_or_else(|| bug!("a law reads {op:?}"));
        }
        let get = |value: Value| values[value.index()];
        let timed = self.motors.iter().map(|timed| {
            let rates = [timed.rate, timed.second].map(|rate| rate.map_or(0.0, get));
            [get(timed.value), rates[0], rates[1]]
        });
        timed.collect()
    }
}
