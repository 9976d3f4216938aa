//! The times through which motors follow their laws, where these decide what is measured.

use super::round_of;
use crate::certify::{Interval, Sources, first_jump};
use crate::compiled::Compiled;
use crate::evaluate::Machine;
use crate::model::{InputId, Model, MotorId, Requirement};
use crate::program::{Following, Gauge, InTime, Op, Position, Program, Timing, Value};
use crate::structure::{RequirementTrouble, WitnessPlace};

/// A place is visited over so many others, each a little later.
const STEPS: u32 = 512;

/// Motors that follow laws.
pub(super) struct Timed {
    /// Their positions in time.
    pub(super) laws: InTime,
    /// Their laws, as they are at run time.
    timing: Timing,
    /// The values of all params.
    params: Vec<f64>,
}

impl Timed {
    /// The laws of a mechanism with this program of positions. A requirement must not say where motors are that follow them.
    pub(super) fn new(
        model: &Model,
        positions: &Program,
        timing: Timing,
        requirement: &Requirement,
    ) -> Result<Self, RequirementTrouble> {
        let laws = InTime::new(model, positions);
        let follows = |motor: MotorId| laws.motors.iter().any(|one| one.motor == motor);
        let mut cases = requirement.cases.iter();
        if let Some(case) = cases.find(|case| follows(case.motor)) {
            return Err(RequirementTrouble::Follows { motor: case.motor, origin: case.origin });
        }
        Ok(Self { laws, timing, params: model.params.values().collect() })
    }

    /// The number of the input that is the time.
    pub(super) fn input(&self) -> usize {
        self.laws.time.index()
    }

    /// The times for which a requirement is proved, and whether everything comes round in them: those that it gives, or else a period.
    /// `any` measures it at any rates, and `found` is what it then finds.
    pub(super) fn times(
        &self,
        model: &Model,
        compiled: &Compiled,
        requirement: &Requirement,
        (any, found): (&Gauge, &[Value]),
    ) -> Result<(Interval, bool), RequirementTrouble> {
        if let Some([low, high]) = requirement.times {
            return Ok((Interval::new(low, high), false));
        }
        let loops = compiled.plan.loops().count();
        let parts = self.parts(any, found);
        let rounds = parts.iter().map(|(following, _)| {
            let motor = following.motor;
            let round = round_of(model, &any.program, (loops, motor.index()), found);
            (motor, round)
        });
        let rounds: Vec<(MotorId, Option<f64>)> = rounds.collect();
        if rounds.is_empty() {
            // Nothing follows a law.
            return Ok((Interval::ZERO, true));
        }
        let period = model.period_of_rounds(&rounds);
        let period = period.ok_or(RequirementTrouble::NoTimes { goes_on: false })?;
        Ok((Interval::new(0.0, period), true))
    }

    /// The motors that have a part in what is found at any rates: with whether their second rates do.
    fn parts(&self, any: &Gauge, found: &[Value]) -> Vec<(&Following, bool)> {
        let sources = Sources::of(&any.program, found);
        let parts = self.laws.motors.iter().filter_map(|following| {
            let motor = following.motor;
            let is_accelerated = sources.read(&any.program, Op::Acceleration(motor));
            let mut others = [Op::Rate(motor), Op::Input(InputId::of_motor(motor))].into_iter();
            let has_part = is_accelerated || others.any(|op| sources.read(&any.program, op));
            has_part.then_some((following, is_accelerated))
        });
        parts.collect()
    }

    /// Refuses laws that jump in these times, as far as that has a part in what is found: a motor that jumps has no velocity, and one whose
    /// rate jumps no acceleration. `any` measures it at any rates, and `found` is what it then finds.
    pub(super) fn refuse_jumps(
        &self,
        times: Interval,
        (any, found): (&Gauge, &[Value]),
    ) -> Result<(), RequirementTrouble> {
        let range = (self.input(), times);
        let refuse = |motor: MotorId, value: Value, is_rate: bool| {
            let found = first_jump(&self.laws.program, value, range);
            found.map_or(Ok(()), |at| Err(RequirementTrouble::Jumps { motor, at, is_rate }))
        };
        for (following, is_accelerated) in self.parts(any, found) {
            refuse(following.motor, following.value, false)?;
            if is_accelerated {
                refuse(following.motor, following.rate, true)?;
            }
        }
        Ok(())
    }

    /// The values of all motors at a time; of those without a law that changes these.
    fn motors(&self, time: f64, others: &[f64]) -> Vec<f64> {
        let mut motors = others.to_vec();
        let at = self.timing.at(time, &self.params);
        for (law, [value, ..]) in self.timing.motors.iter().zip(at) {
            motors[law.motor.index()] = value;
        }
        motors
    }

    /// The position at a place to which motors come from the start: first those without a law, then all others as time goes on. The
    /// time is among its inputs.
    pub(super) fn visit(&self, program: &Program, place: &[f64]) -> Option<Position<f64>> {
        let (others, time) = (&place[..program.motors.len()], place[self.input()]);
        let mut machine = Machine::<f64>::new(program);
        for step in 0..=STEPS {
            let time = time * f64::from(step) / f64::from(STEPS);
            machine.move_to(&self.motors(time, others)).ok()?;
        }
        let mut position = machine.into_position();
        position.motors.push(time);
        position.turns.push(0);
        Some(position)
    }

    /// A place in words of the requirement: the time, and where all motors are that follow laws, or are told for another reason.
    pub(super) fn place(&self, place: &[f64], told: impl Fn(MotorId) -> bool) -> WitnessPlace {
        let time = place[self.input()];
        let follows = |motor: MotorId| self.laws.motors.iter().any(|one| one.motor == motor);
        let others = &place[..self.laws.program.motors.len()];
        let motors = self.motors(time, others).into_iter().enumerate();
        let motors = motors.map(|(motor, value)| (MotorId::new(motor), value));
        WitnessPlace {
            time: Some(time),
            motors: motors.filter(|(motor, _)| follows(*motor) || told(*motor)).collect(),
        }
    }
}
