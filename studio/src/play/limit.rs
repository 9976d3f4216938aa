//! Limits of mechanisms.

use super::{Mechanism, Obstacle};

/// A limit at which a mechanism is.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// The obstacle in the way.
    pub obstacle: Obstacle,
    /// The motors that could not move on.
    pub motors: Vec<usize>,
}

impl Limit {
    /// The joints that stop it and those whose motor cannot move on: the place of each in the scene, and whether it has such a motor.
    #[must_use]
    pub fn places(&self, mechanism: &Mechanism) -> Vec<([f64; 2], bool)> {
        let motors: Vec<_> = self
            .motors
            .iter()
            .filter_map(|&motor| mechanism.joint_of_motor(motor))
            .collect();
        let others = mechanism.joints_in_the_way(self.obstacle);
        let others = others.into_iter().filter(|joint| !motors.contains(joint));
        let others: Vec<_> = others.map(|joint| (joint, false)).collect();
        let all = motors.iter().map(|&joint| (joint, true)).chain(others);
        all.filter_map(|(joint, is_motor)| Some((mechanism.joint(joint)?, is_motor)))
            .collect()
    }

    /// The place and the cause, as a sentence.
    #[must_use]
    pub fn sentence(&self, mechanism: &Mechanism) -> String {
        let values = mechanism.motors();
        let stopped = self.motors.iter().filter_map(|&motor| {
            let name = mechanism.motor_name(motor)?;
            let value = mechanism.shown(motor, *values.get(motor)?)?;
            Some(format!("motor `{name}` stopped at {value}"))
        });
        let stopped: Vec<String> = stopped.collect();
        let cause = mechanism.cause(self.obstacle);
        format!("{}: {cause}", stopped.join(", "))
    }
}
