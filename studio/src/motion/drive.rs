//! A motion of all motors: one of them alone, or all by their laws.

use super::obstacle::{motor_name, obstacle};
use super::setting::{from_shown, motor_of, show_value, turns};
use super::{Setting, Span};
use crate::failure::Failure;
use mech_compiler::Compiled;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{Model, MotorId};
use std::f64::consts::TAU;

/// A motion of all motors.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Drive {
    /// The values of all motors before it, in radians or scene units.
    base: Vec<f64>,
    kind: Kind,
    /// Its ends: values of the motor in radians or scene units, or times.
    ends: [f64; 2],
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// This motor alone.
    Motor(MotorId),
    /// All motors by their laws of time.
    Laws,
}

/// What the motors do at a moment.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Moment {
    /// What the motion is driven by: the value of its motor in radians or scene units, or the time.
    pub(crate) by: f64,
    /// The time since the motion began, in seconds; not finite where the motor rests. By laws it is that of the laws.
    pub(crate) time: f64,
    /// The values of all motors.
    pub(crate) values: Vec<f64>,
    /// Their rates, and their second rates.
    pub(crate) rates: [Vec<f64>; 2],
}

impl Drive {
    /// The motion of one motor, the others as they are set; or that by the laws of the motors, if no motor is named and some have laws.
    ///
    /// Without a span a motor goes through its declared range, or round once, or as far as the mechanism lets it.
    pub(crate) fn new(
        model: &Model,
        compiled: &Compiled,
        motor: Option<&str>,
        span: Span,
        settings: &[Setting],
    ) -> Result<Self, Failure> {
        let mut base = compiled.program.start.motors[..model.motors.len()].to_vec();
        for setting in settings {
            let (motor, value) = setting.resolve(model)?;
            base[motor.index()] = value;
        }
        if motor.is_none() && model.lawful_motors().next().is_some() {
            let ends = [span.from.unwrap_or(0.0), span.to.unwrap_or(1.0)];
            let kind = Kind::Laws;
            return Ok(Self { base, kind, ends });
        }
        let motor = if let Some(name) = motor {
            motor_of(model, name)?
        } else {
            let mut motors = model.motor_ids();
            let first = motors.next();
            first.ok_or_else(|| Failure::mechanism("the mechanism has no motor"))?
        };
        let joint = model.motor(motor).joint;
        let [from, to] =
            [span.from, span.to].map(|end| end.map(|end| from_shown(model, joint, end)));
        let ends = if let (Some(from), Some(to)) = (from, to) {
            [from, to]
        } else {
            let [low, high] = reachable(model, compiled, motor, &base)?;
            [from.unwrap_or(low), to.unwrap_or(high)]
        };
        let kind = Kind::Motor(motor);
        Ok(Self { base, kind, ends })
    }

    /// The motor that moves alone, if one does.
    pub(crate) fn motor(&self) -> Option<MotorId> {
        match self.kind {
            Kind::Motor(motor) => Some(motor),
            Kind::Laws => None,
        }
    }

    /// Whether its end is its beginning: whole turns.
    pub(crate) fn is_cyclic(&self, model: &Model) -> bool {
        let Kind::Motor(motor) = self.kind else {
            return true;
        };
        let whole = (self.ends[1] - self.ends[0]) / TAU;
        turns(model, model.motor(motor).joint)
            && whole != 0.0
            && (whole - whole.round()).abs() < 1e-9
    }

    /// The same over so many turns that everything comes back to where it was, behind gears, too; as it is, if nothing like that is found.
    pub(crate) fn completed(self, model: &Model, compiled: &Compiled) -> Self {
        /// So many turns are tried.
        const MOST: u32 = 64;
        let Kind::Motor(_) = self.kind else {
            return self;
        };
        let [from, to] = self.ends;
        let mut machine = Machine::<f64>::new(&compiled.program);
        if !self.is_cyclic(model) || self.move_to(model, compiled, &mut machine, 0.0).is_err() {
            return self;
        }
        let start = machine.position().poses.clone();
        for turns in 1..=MOST {
            let part = f64::from(turns);
            if self.move_to(model, compiled, &mut machine, part).is_err() {
                return self;
            }
            if are_near(&start, &machine.position().poses) {
                let ends = [from, from + (to - from) * part];
                return Self { ends, ..self };
            }
        }
        self
    }

    /// What the motors do after a part of the motion, 0 to 1, where the motor moves at this rate; by laws at theirs.
    pub(crate) fn moment(
        &self,
        model: &Model,
        compiled: &Compiled,
        part: f64,
        rate: f64,
    ) -> Moment {
        let [from, to] = self.ends;
        let by = from + (to - from) * part;
        let time = match self.kind {
            Kind::Motor(_) => (by - from) / rate,
            Kind::Laws => by,
        };
        let mut values = self.base.clone();
        let mut rates = [vec![0.0; values.len()], vec![0.0; values.len()]];
        match (self.kind, &compiled.timing) {
            (Kind::Motor(motor), _) => {
                values[motor.index()] = by;
                rates[0][motor.index()] = rate;
            }
            (Kind::Laws, Some(timing)) => {
                let params: Vec<f64> = model.params.values().collect();
                for (law, found) in timing.motors.iter().zip(timing.at(by, &params)) {
                    let motor = law.motor.index();
                    values[motor] = found[0];
                    rates[0][motor] = found[1];
                    rates[1][motor] = found[2];
                }
            }
            (Kind::Laws, None) => {}
        }
        Moment {
            by,
            time,
            values,
            rates,
        }
    }

    /// Moves a mechanism to a part of the motion.
    pub(crate) fn move_to(
        &self,
        model: &Model,
        compiled: &Compiled,
        machine: &mut Machine<'_, f64>,
        part: f64,
    ) -> Result<(), Failure> {
        let Moment { by, values, .. } = self.moment(model, compiled, part, 0.0);
        machine.move_to(&values).map_err(|stop| {
            let why = obstacle(model, compiled, stop);
            Failure::mechanism(match self.kind {
                Kind::Motor(motor) => {
                    let joint = model.motor(motor).joint;
                    let value = show_value(model, joint, by);
                    let name = motor_name(model, motor);
                    format!(
                        "motor `{name}` cannot come to {value}: {why}{}",
                        limits(model, compiled, motor, &self.base)
                    )
                }
                Kind::Laws => format!("the motors cannot follow their laws at t = {by}: {why}"),
            })
        })
    }
}

/// Whether links with these poses are seen at the same places.
fn are_near(a: &[[f64; 4]], b: &[[f64; 4]]) -> bool {
    const NEAR: f64 = 1e-6;
    let size = a
        .iter()
        .flatten()
        .fold(1.0, |size: f64, part| size.max(part.abs()));
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.into_iter().all(|(a, b)| (a - b).abs() < NEAR * size)
}

/// Between which values a motor can move, for a message.
fn limits(model: &Model, compiled: &Compiled, motor: MotorId, base: &[f64]) -> String {
    let joint = model.motor(motor).joint;
    match reachable(model, compiled, motor, base) {
        Ok(ends) => {
            let [low, high] = ends.map(|end| show_value(model, joint, end));
            format!("; it can go from {low} to {high}")
        }
        Err(_) => String::new(),
    }
}

/// The ends of a motor's declared range, if it has one.
pub(crate) fn range_of(model: &Model, motor: MotorId) -> Option<[f64; 2]> {
    let range = model.motor(motor).range.as_ref()?;
    let ends = [range.low, range.high];
    ends.iter().all(|end| end.is_finite()).then_some(ends)
}

/// The values through which a motor moves if nobody says which: its declared range; or once round; or as far as it can go.
fn reachable(
    model: &Model,
    compiled: &Compiled,
    motor: MotorId,
    base: &[f64],
) -> Result<[f64; 2], Failure> {
    if let Some(ends) = range_of(model, motor) {
        return Ok(ends);
    }
    if !turns(model, model.motor(motor).joint) {
        let name = motor_name(model, motor);
        return Err(Failure::usage(format!(
            "motor `{name}` slides, and declares no range; say where with `--from` and `--to`, in scene units"
        )));
    }
    let found = reach(model, compiled, motor, base, TAU)?;
    Ok(if found.is_free {
        [base[motor.index()], found.ends[1]]
    } else {
        found.ends
    })
}

/// How far a motor moves alone from where it is, both ways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reach {
    /// Its lowest and highest value, in radians or scene units.
    pub(crate) ends: [f64; 2],
    /// Whether nothing stops it on its way up.
    pub(crate) is_free: bool,
}

/// How far a motor moves alone from these values of all motors, both ways, no farther than this distance.
pub(crate) fn reach(
    model: &Model,
    compiled: &Compiled,
    motor: MotorId,
    base: &[f64],
    distance: f64,
) -> Result<Reach, Failure> {
    let mut machine = Machine::<f64>::new(&compiled.program);
    let blocked = |stop| {
        Failure::mechanism(format!(
            "the motors cannot come to these values: {}",
            obstacle(model, compiled, stop)
        ))
    };
    machine.move_to(base).map_err(blocked)?;
    let start = machine.position().clone();
    let index = motor.index();
    let mut end = |displacement: f64| -> Result<(f64, bool), Failure> {
        machine.put_back(start.clone());
        let mut goal = base.to_vec();
        goal[index] += displacement;
        let stop = machine.move_toward(&goal).map_err(blocked)?;
        Ok((machine.position().motors[index], stop.is_none()))
    };
    let (high, is_free) = end(distance)?;
    let (low, _) = end(-distance)?;
    Ok(Reach {
        ends: [low, high],
        is_free,
    })
}
