//! One step of a program: all its operations, one after the other.

use super::Stop;
use crate::bug::bug;
use crate::cancel;
use crate::program::{
    BlockId, BlockKind, ClosedForm, Forces, LinkRates, Newton, Op, Position, Program, RateMargin,
    Results, Rounds, System, Value,
};
use mech_core::Real;
use mech_core::contraction::{before_first, contracts};
use mech_core::dense::solve;
use mech_core::motors::turned;
use std::borrow::Cow;
use std::cell::{Cell, RefCell};

/// The inputs of a program of rates or forces, besides the motors' values.
#[derive(Clone, Copy, Debug)]
pub(super) struct MotionInputs<'g, T> {
    pub(super) rates: &'g [T],
    pub(super) accelerations: &'g [T],
    pub(super) loads: &'g [T],
}

/// A program that is ready to be run, in any precision, whatever it was compiled for.
#[derive(Clone, Debug)]
pub(super) struct Runner<'p, T: Real> {
    pub(super) program: &'p Program,
    prepared: Cow<'p, Prepared<T>>,
    /// The number of operations that it may still make.
    pub(super) left: Cell<usize>,
    /// The values of the last step, the constants among them, to be used again.
    values: RefCell<Vec<T>>,
}

/// The data that are made once of a program so that it can be run.
#[derive(Clone, Debug)]
pub struct Prepared<T> {
    /// For each node its value if that is a constant, else zero.
    constants: Vec<T>,
    /// The operations that are computed once, without constants, in order.
    steps: Vec<Step>,
    /// The number of steps up to the last that positions need: rates and forces stand behind it.
    of_position: usize,
    /// The operations that each block repeats in every round of its iteration.
    rounds: Vec<Vec<Step>>,
}

/// An operation, and the value that it makes. They stand side by side, as programs are run many thousand times.
#[derive(Clone, Copy, Debug)]
struct Step {
    value: Value,
    op: Op,
}

/// Whether a loop closes.
fn is_closed<T: Real>(closed: &ClosedForm, values: &[T]) -> bool {
    values[closed.margin.index()] >= T::ZERO
}

impl<T: Real> Prepared<T> {
    /// That of this program.
    #[must_use]
    pub fn new(program: &Program) -> Self {
        let mut constants = vec![T::ZERO; program.ssa.nodes.len()];
        let mut steps = Vec::new();
        let mut rounds = vec![Vec::new(); program.ssa.blocks.len()];
        for value in program.live_values() {
            let node = program.node(value);
            let step = Step { value, op: node.op };
            match node.op {
                Op::Constant(number) => constants[value.index()] = T::from_f64(number.get()),
                Op::Unknown(..) if node.iterated => {}
                _ if node.iterated => rounds[node.block.index()].push(step),
                _ => steps.push(step),
            }
        }
        let poses = program.poses.iter().flatten();
        let margins = program.margins().map(|(_, closed)| &closed.margin);
        let last = poses.chain(&program.state).chain(margins).max();
        let of_position = steps.partition_point(|step| Some(&step.value) <= last);
        Self { constants, steps, of_position, rounds }
    }
}

impl<'p, T: Real> Runner<'p, T> {
    pub(super) fn new(program: &'p Program) -> Self {
        Self {
            program,
            prepared: Cow::Owned(Prepared::new(program)),
            left: Cell::new(usize::MAX),
            values: RefCell::default(),
        }
    }

    /// A program that was prepared before.
    pub(super) fn of(program: &'p Program, prepared: &'p Prepared<T>) -> Self {
        Self {
            program,
            prepared: Cow::Borrowed(prepared),
            left: Cell::new(usize::MAX),
            values: RefCell::default(),
        }
    }

    /// Runs the program once.
    pub(super) fn step(
        &self,
        last: &Position<T>,
        (motors, turns): (&[T], &[i32]),
    ) -> Result<Position<T>, Stop> {
        let steps = &self.prepared.steps[..self.prepared.of_position];
        self.spend(steps.len() + 1)?;
        let zero = vec![T::ZERO; motors.len()];
        let given = MotionInputs { rates: &zero, accelerations: &zero, loads: &[] };
        let mut values = self.values.take();
        if values.is_empty() {
            values.clone_from(&self.prepared.constants);
        }
        let values = self.values_of(steps, values, last, (motors, turns), given)?;
        let position = match self.open(&values) {
            None => self.position(&values, (motors, turns)),
            Some(block) => Err(Stop::Open(block)),
        };
        self.values.replace(values);
        position
    }

    /// Counts operations: none are made that are not left.
    fn spend(&self, operations: usize) -> Result<(), Stop> {
        let left = self.left.get().checked_sub(operations);
        self.left.set(left.unwrap_or(0));
        left.map(drop).ok_or(Stop::TooFar)
    }

    /// The rates of everything at a position.
    pub(super) fn motion(
        &self,
        at: &Position<T>,
        given: MotionInputs<'_, T>,
    ) -> Result<LinkRates<T>, Stop> {
        let Some(Results::Rates(rates)) = self.program.results() else {
            return Err(Stop::Unasked);
        };
        let values = self.determined_values(at, given)?;
        let moved = rates.map(|value| values[value.index()]);
        if moved.roots().all(Real::is_finite) { Ok(moved) } else { Err(Stop::Overflow) }
    }

    /// The forces at a position.
    pub(super) fn forces(
        &self,
        at: &Position<T>,
        given: MotionInputs<'_, T>,
    ) -> Result<Forces<T>, Stop> {
        let Some(Results::Forces { forces, loads }) = self.program.results() else {
            return Err(Stop::Unasked);
        };
        if given.loads.len() != loads.len() {
            return Err(Stop::MotorCount);
        }
        let values = self.determined_values(at, given)?;
        let found = forces.map(|value: Value| values[value.index()]);
        if found.roots().iter().all(|number| number.is_finite()) {
            Ok(found)
        } else {
            Err(Stop::Overflow)
        }
    }

    /// All values of the program where it is, if rates are determined there.
    pub(super) fn determined_values(
        &self,
        at: &Position<T>,
        given: MotionInputs<'_, T>,
    ) -> Result<Vec<T>, Stop> {
        let values = self.values(at, (&at.motors, &at.turns), given);
        // A loop that closed where it is, and does not once more, is at its limit.
        let values = values.map_err(|stop| match stop {
            Stop::Open(block) | Stop::DeadPoint(block) => Stop::Singular(self.number(block)),
            other => other,
        })?;
        let mut margins = self.program.rate_margins().iter();
        let regular = |margin: &RateMargin| values[margin.margin.index()] >= T::ZERO;
        match margins.position(|margin| !regular(margin)) {
            None => Ok(values),
            Some(first) => Err(Stop::Singular(first)),
        }
    }

    /// The number of the loop that a block closes.
    fn number(&self, block: BlockId) -> usize {
        let Some(number) = self.program.loop_of(block) else {
            bug!("block {} closes no loop", block.index());
        };
        number
    }

    /// All values of the program.
    fn values(
        &self,
        last: &Position<T>,
        inputs: (&[T], &[i32]),
        given: MotionInputs<'_, T>,
    ) -> Result<Vec<T>, Stop> {
        let values = self.values_even_if_open(last, inputs, given)?;
        match self.open(&values) {
            None => Ok(values),
            Some(block) => Err(Stop::Open(block)),
        }
    }

    /// The first loop in closed form that is open.
    pub(super) fn open(&self, values: &[T]) -> Option<BlockId> {
        let mut margins = self.program.margins();
        let open = margins.find(|(_, closed)| !is_closed(closed, values));
        open.map(|(block, _)| block)
    }

    /// The same, but loops in closed form may be open: values that depend on such a loop mean nothing.
    pub(super) fn values_even_if_open(
        &self,
        last: &Position<T>,
        inputs: (&[T], &[i32]),
        given: MotionInputs<'_, T>,
    ) -> Result<Vec<T>, Stop> {
        let constants = self.prepared.constants.clone();
        self.values_of(&self.prepared.steps, constants, last, inputs, given)
    }

    /// The values of all nodes after these steps, in the place of values that hold the constants.
    fn values_of(
        &self,
        steps: &[Step],
        mut values: Vec<T>,
        last: &Position<T>,
        (motors, turns): (&[T], &[i32]),
        given: MotionInputs<'_, T>,
    ) -> Result<Vec<T>, Stop> {
        let reduced = |(input, (&value, &turns)): (usize, (&T, &i32))| {
            let is_reduced = self.program.reduced.get(input) == Some(&true);
            if is_reduced { mech_core::motors::reduced(value, turns) } else { (value, turns) }
        };
        let inputs = motors.iter().zip(turns).enumerate().map(reduced);
        let (motors, turns): (Vec<T>, Vec<i32>) = inputs.unzip();
        let mut solved = vec![false; self.program.ssa.blocks.len()];
        cancel::check();
        for &Step { value, op } in steps {
            if let Op::Solved(block, _) = op
                && !std::mem::replace(&mut solved[block.index()], true)
                && let BlockKind::Newton(newton) = &self.program.ssa.blocks[block.index()].kind
            {
                let mut before = self.program.margins().take_while(|(id, _)| *id < block);
                if let Some((open, _)) = before.find(|(_, closed)| !is_closed(closed, &values)) {
                    return Err(Stop::Open(open));
                }
                self.iterate(block, newton, &mut values)?;
            }
            values[value.index()] = match op {
                Op::Input(input) => motors[input.index()],
                Op::Turns(motor) => T::from_i32(turns[motor.index()]),
                Op::PartOfTurns(motor, numerator, denominator) => {
                    turned(turns[motor.index()], numerator, denominator)
                }
                Op::Last(slot) => last.at(slot),
                Op::Rate(motor) => given.rates[motor.index()],
                Op::Acceleration(motor) => given.accelerations[motor.index()],
                // Positions do not depend on loads, and are found without.
                Op::Load(number) => given.loads.get(number).copied().unwrap_or(T::ZERO),
                Op::Linear(system, index) => self.linear(system, index, &values),
                Op::Solved(block, index) => self.scalar(block, index, &values),
                op => {
                    let made = op.apply(|value| values[value.index()]);
                    made.unwrap_or_else(|| bug!("nothing gives {op:?}"))
                }
            };
        }
        Ok(values)
    }

    pub(super) fn position(
        &self,
        values: &[T],
        (motors, turns): (&[T], &[i32]),
    ) -> Result<Position<T>, Stop> {
        let get = |value: &Value| values[value.index()];
        let poses: Vec<[T; 4]> =
            self.program.poses.iter().map(|pose| pose.map(|value| get(&value))).collect();
        let state: Vec<T> = self.program.state.iter().map(get).collect();
        let mut numbers = poses.iter().flatten().chain(&state);
        if numbers.any(|number| !number.is_finite()) {
            return Err(Stop::Overflow);
        }
        Ok(Position { motors: motors.to_vec(), turns: turns.to_vec(), poses, state })
    }

    /// An unknown of a linear system, or after these its determinant.
    fn linear(&self, system: usize, index: usize, values: &[T]) -> T {
        let System { columns, right, .. } = &self.program.systems()[system];
        solve_system(columns, right, values)[index]
    }

    /// The present value of an unknown: it stands in the place of the node that reads it inside the iteration.
    fn scalar(&self, block: BlockId, index: usize, values: &[T]) -> T {
        let Some(newton) = self.program.newton(block) else {
            bug!("block {} iterates no loop", block.index());
        };
        values[newton.scalars[index].now.index()]
    }

    fn iterate(&self, block: BlockId, newton: &Newton, values: &mut [T]) -> Result<(), Stop> {
        for scalar in &newton.scalars {
            values[scalar.now.index()] = values[scalar.first.index()];
        }
        let within = |values: &[T], part: f64| {
            let fixed = newton.limits.size;
            let limit = match newton.extent {
                None => T::from_f64(part * fixed),
                Some(extent) => T::from_f64(part) * (T::from_f64(fixed) + values[extent.index()]),
            };
            let small = |value: Value| values[value.index()].abs() <= limit;
            newton.gap.iter().copied().all(small)
        };
        let mut rounds = 0;
        let mut before = before_first();
        loop {
            let mut dense = None;
            self.spend(self.prepared.rounds[block.index()].len())?;
            for &Step { value, op } in &self.prepared.rounds[block.index()] {
                if let Op::Dense(_, index) = op {
                    let solve = || solve_system(&newton.columns, &newton.gap, values);
                    values[value.index()] = dense.get_or_insert_with(solve)[index];
                } else if let Some(result) = op.apply(|value| values[value.index()]) {
                    values[value.index()] = result;
                }
            }
            let done = match newton.rounds {
                Rounds::Exactly(exact) => rounds == exact,
                Rounds::UntilClosed(most) => {
                    rounds == most || within(values, newton.tight(T::EPSILON))
                }
            };
            if done && (rounds == 0 || !newton.steps_on()) {
                break;
            }
            if !done
                && let Some(step) = newton.contracting_step()
                && !contracts(&mut before, values[step.index()])
            {
                break;
            }
            let next: Vec<T> =
                newton.scalars.iter().map(|scalar| values[scalar.next.index()]).collect();
            for (scalar, next) in newton.scalars.iter().zip(next) {
                values[scalar.now.index()] = next;
            }
            if done {
                break;
            }
            rounds += 1;
        }
        if !within(values, newton.accept(T::EPSILON)) {
            return Err(Stop::Open(block));
        }
        let det = values[newton.det.index()];
        let det = if newton.limits.positive { det } else { -det };
        if det >= T::from_f64(newton.floor(T::EPSILON)) {
            Ok(())
        } else {
            Err(Stop::DeadPoint(block))
        }
    }
}

/// The unknowns of a linear system, and after these its determinant: the columns times the unknowns and the right side add to zero.
fn solve_system<T: Real>(columns: &[Vec<Value>], right: &[Value], values: &[T]) -> Vec<T> {
    let get = |value: &Value| values[value.index()];
    let row = |row: usize| -> Vec<T> { columns.iter().map(|column| get(&column[row])).collect() };
    let mut rows: Vec<Vec<T>> = (0..right.len()).map(row).collect();
    let mut unknowns: Vec<T> = right.iter().map(|right| -get(right)).collect();
    let det = solve(&mut rows, &mut unknowns);
    unknowns.push(det);
    unknowns
}
