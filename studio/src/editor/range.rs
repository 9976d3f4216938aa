//! The ranges of motors.

use crate::failure::Failure;
use crate::motion::{Basis, Reach, turns};
use mech_compiler::Compiled;
use mech_compiler::model::Model;

/// The range of a motor that moves alone from the start.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct MotorRange {
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

/// Finds the range of each motor, in the order of declaration. A motor that slides without a declared range goes half as far as the
/// mechanism is large.
pub(crate) fn ranges(model: &Model, compiled: &Compiled) -> Result<Vec<MotorRange>, Failure> {
    let base = &compiled.program.start.motors[..model.motors.len()];
    let motors = model.motor_ids().map(|motor| {
        let joint = model.motor(motor).joint;
        let Reach { ends, basis, .. } = Reach::of(model, compiled, motor, base)?;
        Ok(MotorRange {
            name: model.joint(joint).name.clone(),
            ends,
            basis,
            turns: turns(model, joint),
        })
    });
    motors.collect()
}
