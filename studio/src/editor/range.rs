//! The ranges of motors.

use crate::failure::Failure;
use crate::motion::{range_of, reach, turns};
use mech_compiler::Compiled;
use mech_compiler::model::Model;
use std::f64::consts::TAU;

/// The range of a motor that moves alone from the start.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct MotorRange {
    /// The name of its joint.
    pub(crate) name: String,
    /// Its lowest and highest value, in radians or scene units.
    pub(crate) ends: [f64; 2],
    pub(crate) basis: Basis,
    /// Whether its values are angles.
    pub(crate) turns: bool,
}

impl MotorRange {
    /// A value as it is shown: in degrees or scene units.
    pub(crate) fn shown(&self, value: f64) -> f64 {
        if self.turns {
            value.to_degrees()
        } else {
            value
        }
    }

    /// The value that is meant by one as it is shown.
    pub(crate) fn meant(&self, shown: f64) -> f64 {
        if self.turns {
            shown.to_radians()
        } else {
            shown
        }
    }
}

/// The basis on which a range is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Basis {
    /// It was declared, and the compiler has proved it.
    Proved,
    /// The motor was moved until something stopped it.
    Walked,
    /// The motor was moved once round, and nothing stopped it.
    Round,
}

/// Finds the range of each motor, in the order of declaration. A motor that slides without a declared range goes half as far as the
/// mechanism is large.
pub(crate) fn ranges(model: &Model, compiled: &Compiled) -> Result<Vec<MotorRange>, Failure> {
    let base = &compiled.program.start.motors[..model.motors.len()];
    let size = model.size();
    let motors = model.motor_ids().map(|motor| {
        let joint = model.motor(motor).joint;
        let turns = turns(model, joint);
        let (ends, basis) = if let Some(ends) = range_of(model, motor) {
            (ends, Basis::Proved)
        } else {
            let found = reach(
                model,
                compiled,
                motor,
                base,
                if turns { TAU } else { size / 2.0 },
            )?;
            let start = base[motor.index()];
            if turns && found.is_free[1] {
                ([start, start + TAU], Basis::Round)
            } else {
                (found.ends, Basis::Walked)
            }
        };
        Ok(MotorRange {
            name: model.joint(joint).name.clone(),
            ends,
            basis,
            turns,
        })
    });
    motors.collect()
}
