//! Where a mechanism could not go on.

use mech_examples::Playable;
use mech_runtime::{Blocked, Cause};

/// A limit that a mechanism is at.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// What it had to say.
    pub blocked: Blocked<Vec<f64>>,
    /// The motors that were to go on.
    pub motors: Vec<usize>,
}

impl Limit {
    /// The joints that stand in the way, or whose motor does not go on: where each is in the scene.
    #[must_use]
    pub fn joints(&self, mechanism: &dyn Playable) -> Vec<[f64; 2]> {
        let motors = self
            .motors
            .iter()
            .filter_map(|&motor| mechanism.motor_names().get(motor).copied());
        let names = self.names().into_iter().chain(motors);
        let mut places: Vec<[f64; 2]> = Vec::new();
        for place in names.filter_map(|name| mechanism.joint(name)) {
            if !places.contains(&place) {
                places.push(place);
            }
        }
        places
    }

    /// Where it is and why, for people.
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

    /// What stopped it.
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

    /// The joints of the place that is told.
    fn names(&self) -> Vec<&'static str> {
        let parts = self
            .blocked
            .place
            .split(|c: char| !c.is_alphanumeric() && c != '_');
        parts.filter(|name| !name.is_empty()).collect()
    }
}

/// The coordinate of a motor, for people: an angle in degrees, or a length.
#[must_use]
pub(crate) fn coordinate(mechanism: &dyn Playable, motor: &str, value: f64) -> String {
    if mechanism.slides(motor) {
        format!("{value:.3}")
    } else {
        format!("{:.1}°", value.to_degrees())
    }
}
