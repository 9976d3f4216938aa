//! The reaches of motors.

use super::Mover;
use super::obstacle::obstacle;
use super::setting::{from_shown, range_of, shown, unit_of};
use crate::failure::Failure;
use mech_compiler::Compiled;
use mech_compiler::evaluate::{Machine, Stop};
use mech_compiler::model::{Model, MotorId};
use std::f64::consts::TAU;

/// A part of a way that is more than rounding.
const HAIR: f64 = 1e-8;

/// How far a motor goes that moves alone from where it is, both ways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reach {
    /// Its lowest and highest value, in radians or scene units.
    pub(crate) ends: [f64; 2],
    pub(crate) basis: Basis,
    /// What stops it at each of them, if it was moved there and something does.
    pub(crate) stops: [Option<Stop>; 2],
}

/// The basis on which a reach is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Basis {
    /// It was declared, and the compiler has proved it.
    Declared,
    /// The motor was moved once round, and nothing stopped it.
    Round,
    /// The motor was moved until something stopped it, or far enough.
    Walked,
}

impl Reach {
    /// The reach of a motor from these values of all motors: its declared range; or once round; or as far as it can go. A slide that nothing
    /// stops goes half as far as the mechanism is large.
    ///
    /// # Errors
    /// If the motors cannot come to these values.
    pub(crate) fn of(
        model: &Model,
        compiled: &Compiled,
        motor: MotorId,
        base: &[f64],
    ) -> Result<Self, Failure> {
        /// The farthest that a slide is tried, in sizes of the mechanism: nothing in a closed loop goes farther.
        const FAR: f64 = 16.0;
        if let Some(ends) = range_of(model, motor) {
            return Ok(Self { ends, basis: Basis::Declared, stops: [None; 2] });
        }
        let start = base[motor.index()];
        if model.turns(model.motor(motor).joint) {
            let mut found = walked(model, compiled, motor, base, TAU)?;
            if found.stops[1].is_none() {
                found =
                    Self { ends: [start, found.ends[1]], basis: Basis::Round, stops: [None; 2] };
            }
            return Ok(found);
        }
        let size = match model.size() {
            0.0 => 1.0,
            size => size,
        };
        let mut found = walked(model, compiled, motor, base, FAR * size)?;
        for (side, way) in [(0, -0.5), (1, 0.5)] {
            if found.stops[side].is_none() {
                found.ends[side] = start + way * size;
            }
        }
        Ok(found)
    }

    /// At which of its ends something stops it.
    pub(crate) fn is_stopped(&self) -> [bool; 2] {
        self.stops.map(|stop| stop.is_some())
    }
}

/// The reach of a motor both ways, no farther than this distance, whatever was declared.
fn walked(
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
    let mut end = |displacement: f64| -> Result<(f64, Option<Stop>), Failure> {
        machine.put_back(start.clone());
        let mut goal = base.to_vec();
        goal[index] += displacement;
        let stop = machine.move_toward(&goal).map_err(blocked)?;
        let end = machine.position().motors[index];
        if stop.is_none() {
            return Ok((end, None));
        }
        let farthest = farthest(|part| {
            machine.put_back(start.clone());
            goal[index] = base[index] + (end - base[index]) * part;
            machine.move_to(&goal).is_ok()
        });
        Ok((base[index] + (end - base[index]) * farthest, stop))
    };
    let (low, below) = end(-distance)?;
    let (high, above) = end(distance)?;
    Ok(Reach { ends: [low, high], basis: Basis::Walked, stops: [below, above] })
}

/// The greatest part of a way that can be gone at once. A move that was meant to go farther may have come a little farther: where loops are
/// iterated, how it is divided decides.
fn farthest(mut can: impl FnMut(f64) -> bool) -> f64 {
    const HALVED: u32 = 40;
    if can(1.0 - HAIR) {
        return 1.0;
    }
    let [mut done, mut blocked] = [0.0, 1.0 - HAIR];
    for _ in 0..HALVED {
        let middle = f64::midpoint(done, blocked);
        if can(middle) {
            done = middle;
        } else {
            blocked = middle;
        }
    }
    done
}

/// Between which values a motor can move, for a message. What is said here can be reached: it is rounded inwards, unless an end is a round
/// number to rounding and the motor comes there.
pub(super) fn limits(model: &Model, compiled: &Compiled, motor: MotorId, base: &[f64]) -> String {
    let joint = model.motor(motor).joint;
    let Ok(reach) = Reach::of(model, compiled, motor, base) else {
        return String::new();
    };
    let (ends, found) = (reach.ends, reach.is_stopped());
    let comes_to = |value: f64| {
        let mut mover = Mover::new(model, compiled);
        let is_there = mover.move_to(base).is_ok();
        let mut values = base.to_vec();
        values[motor.index()] = value;
        is_there && mover.move_to(&values).is_ok()
    };
    let width = shown(model, joint, ends[1] - ends[0]).abs();
    let digits = 10.0_f64.powf((6.0 - width.log10()).round().clamp(0.0, 15.0));
    let [low, high] = [(0, 1.0), (1, -1.0)].map(|(side, inwards)| {
        let end = shown(model, joint, ends[side]);
        let near = (digits * end).round() / digits;
        let is_round = (near - end).abs() <= HAIR * width;
        let told = if !found[side] || is_round && comes_to(from_shown(model, joint, near)) {
            near
        } else {
            // Downwards at the upper end, upwards at the lower.
            -inwards * (-inwards * digits * (end + inwards * HAIR * width)).floor() / digits
        };
        format!("{}{}", told + 0.0, unit_of(model, joint))
    });
    format!("; it can go from {low} to {high}")
}
