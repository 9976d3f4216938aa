//! Limits of mechanisms.

use mech_gallery::Playable;
use mech_runtime::{Blocked, Cause};

/// A limit at which a mechanism is.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// The error of the move.
    pub blocked: Blocked<Vec<f64>>,
    /// The motors that could not move on.
    pub motors: Vec<usize>,
}

impl Limit {
    /// The joints that stop it and those whose motor cannot move on: the place of each in the scene, and whether it has such a motor.
    #[must_use]
    pub fn places(&self, mechanism: &dyn Playable) -> Vec<([f64; 2], bool)> {
        let names = mechanism.motor_names();
        let motors = self.motors.iter();
        let motors = motors.filter_map(|&motor| names.get(motor).copied());
        let motors: Vec<&str> = motors.collect();
        let others = self.names().into_iter();
        let others = others.filter(|name| !motors.contains(name));
        let others = others.map(|name| (name, false));
        let all = motors.iter().map(|&name| (name, true)).chain(others);
        all.filter_map(|(name, is_motor)| Some((mechanism.joint(name)?, is_motor)))
            .collect()
    }

    /// The place and the cause, as a sentence.
    #[must_use]
    pub fn sentence(&self, mechanism: &dyn Playable) -> String {
        let values = self.motors.iter().filter_map(|&motor| {
            let name = mechanism.motor_names().get(motor)?;
            let value = coordinate(mechanism, name, *self.blocked.reached.get(motor)?);
            Some(format!("motor `{name}` stopped at {value}"))
        });
        let values: Vec<String> = values.collect();
        format!("{}: {}", values.join(", "), self.cause())
    }

    /// The cause, as a phrase.
    fn cause(&self) -> String {
        let joints = self.names().join(", ");
        match self.blocked.cause {
            Cause::Open => format!("dead point, the loop {joints} does not close beyond"),
            Cause::DeadPoint => format!("dead point of the loop {joints}"),
            Cause::ChangePoint => {
                format!("change point of the loop {joints}, where it stops as declared")
            }
            Cause::OutOfRange => format!("end of the declared range of `{joints}`"),
            _ => self.blocked.to_string(),
        }
    }

    /// The joints at the place of the error.
    fn names(&self) -> Vec<&'static str> {
        let parts = self
            .blocked
            .place
            .split(|c: char| !c.is_alphanumeric() && c != '_');
        parts.filter(|name| !name.is_empty()).collect()
    }
}

/// The coordinate of a motor as text: an angle in degrees, or a length.
#[must_use]
pub(crate) fn coordinate(mechanism: &dyn Playable, motor: &str, value: f64) -> String {
    if mechanism.slides(motor) {
        format!("{value:.3}")
    } else {
        format!("{:.1}°", value.to_degrees())
    }
}
