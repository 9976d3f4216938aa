//! Motors that are to be declared, each with a range where the mechanism asks for one.

use super::Repair;
use crate::digits::of_one_digit;
use crate::model::{JointId, JointKind, Model};

/// So far a motor may turn to both sides, in degrees: the widest range that can be proved is offered.
const ANGLES: [f64; 3] = [30.0, 10.0, 2.0];
/// So far it may slide to both sides, as parts of the size.
const WAYS: [f64; 3] = [0.2, 0.05, 0.01];

/// A motor that is to be declared.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NewMotor {
    /// The joint that it drives.
    pub joint: JointId,
    /// The least and the greatest value of its range, in radians or scene units. None for no range, or for that of the motor which is
    /// moved here.
    pub range: Option<[f64; 2]>,
}

impl From<JointId> for NewMotor {
    fn from(joint: JointId) -> Self {
        Self { joint, range: None }
    }
}

impl NewMotor {
    /// Its statement, as `motor a in -10 deg ..= 10 deg;`.
    pub(crate) fn statement(&self, model: &Model) -> String {
        let name = &model.joint(self.joint).name;
        let range = self.range_text(model).map(|range| format!(" in {range}"));
        format!("motor {name}{};", range.unwrap_or_default())
    }

    /// Its range, as `-10 deg ..= 10 deg`.
    pub(crate) fn range_text(&self, model: &Model) -> Option<String> {
        let [low, high] = self.range?.map(|end| value_text(model, self.joint, end));
        Some(format!("{low} ..= {high}"))
    }

    /// With one of the ranges that are tried, the widest first.
    fn with_range(self, model: &Model, number: usize) -> Self {
        let start = model.start.value(self.joint);
        let side = if slides(model, self.joint) {
            of_one_digit(WAYS[number] * model.size())
        } else {
            ANGLES[number].to_radians()
        };
        let range = Some([start - side, start + side]);
        Self { range, ..self }
    }
}

/// Whether a joint has a length as its coordinate.
pub(super) fn slides(model: &Model, joint: JointId) -> bool {
    matches!(model.joint(joint).kind, JointKind::Prismatic(..))
}

/// A coordinate of a joint as one would write it.
pub(super) fn value_text(model: &Model, joint: JointId, value: f64) -> String {
    let degrees = (value.to_degrees() * 1e9).round() / 1e9;
    let is_exact = (degrees.to_radians() - value).abs() < 1e-12;
    if !slides(model, joint) && is_exact { format!("{degrees} deg") } else { format!("{value}") }
}

/// The same change with motors that have ranges, in the order in which these are tried; the change as it is where that is asked for.
pub(super) fn variants(model: &Model, repairs: &[Repair]) -> Vec<Vec<Repair>> {
    let is_ranged = model.motors.iter().any(|motor| motor.range.is_some());
    let with = |number: usize| -> Vec<Repair> {
        let repairs = repairs.iter();
        repairs.map(|repair| with_range(model, repair, number)).collect()
    };
    let ranged: Vec<Vec<Repair>> = (0..ANGLES.len()).map(with).collect();
    let same = repairs.to_vec();
    if ranged[0] == same {
        return vec![same];
    }
    let adds = repairs.iter().any(|repair| matches!(repair, Repair::AddMotors(_)));
    // A motor that is moved keeps its range; one that is added has one where others have.
    if adds && is_ranged { ranged } else { [vec![same], ranged].concat() }
}

fn with_range(model: &Model, repair: &Repair, number: usize) -> Repair {
    match repair {
        Repair::AddMotors(motors) => {
            let motors = motors.iter();
            Repair::AddMotors(motors.map(|motor| motor.with_range(model, number)).collect())
        }
        Repair::MoveMotor { motor, to } if model.motor(*motor).range.is_some() => {
            Repair::MoveMotor { motor: *motor, to: to.with_range(model, number) }
        }
        other => other.clone(),
    }
}
