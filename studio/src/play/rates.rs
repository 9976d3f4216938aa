//! Rates of a mechanism that is played, and the forces in its joints.

use super::{Derived, Mechanism, Rates};
#[cfg(feature = "editor")]
use crate::construction::{Board, Centrodes, Construction};
use crate::motion::Mover;
use crate::painting::poses_of;
#[cfg(feature = "editor")]
use crate::quantity::{self, Surveyed};
use mech_compiler::program::Forces;
use mech_runtime::{Acceleration, Velocity};

/// The place, velocity and acceleration of a point while the motors have rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointRates {
    /// Where it is in the scene.
    pub place: [f64; 2],
    /// Its velocity.
    pub velocity: [f64; 2],
    /// Its acceleration, where it is determined.
    pub acceleration: Option<[f64; 2]>,
}

impl Mechanism {
    /// The velocities and accelerations of its points, while its motors have these rates; none where they are not
    /// [prepared](Self::prepare) or not determined.
    pub(crate) fn point_rates(&self, rates: &Rates) -> Vec<PointRates> {
        let program = self.with(Derived::Rates);
        let program = program.and_then(|found| found.moving.as_ref());
        let Some(program) = program else {
            return Vec::new();
        };
        let mut machine = Mover::of(&self.model, program);
        machine.put_back(&self.position);
        let [first, second] = self.all_rates(rates);
        let Ok(found) = machine.motion([&first, &second]) else {
            return Vec::new();
        };
        let poses = poses_of(&self.position.poses);
        let accelerations = found.accelerations.as_deref().unwrap_or_default();
        let points = self.points.iter().filter_map(|spot| {
            let link = spot.link.checked_sub(1)?;
            let &[angular, x, y] = found.velocities.get(link)?;
            let velocity = Velocity { angular, x, y };
            let pose = *poses.get(link)?;
            let acceleration = accelerations.get(link).map(|&[angular, x, y]| {
                let acceleration = Acceleration { angular, x, y };
                acceleration.of_point(pose, velocity.angular, spot.at)
            });
            Some(PointRates {
                place: pose.apply(spot.at),
                velocity: velocity.of_point(pose, spot.at),
                acceleration,
            })
        });
        points.collect()
    }

    /// The force that the first link of each joint exerts on the second, with the place of the joint, while its motors have these rates and
    /// its loads these numbers; none where forces are not [prepared](Self::prepare) or not determined. Loads that are not given are zero.
    #[must_use]
    pub fn reactions(&self, rates: &Rates, loads: &[f64]) -> Vec<([f64; 2], [f64; 2])> {
        let program =
            self.with(Derived::Forces).and_then(|found| found.forced.inverse_dynamics.as_ref());
        let Some(program) = program else {
            return Vec::new();
        };
        let mut machine = Mover::of(&self.model, program);
        machine.put_back(&self.position);
        let loads = self.all_loads(loads);
        let [first, second] = self.all_rates(rates);
        let Ok(Forces::InverseDynamics(found)) = machine.forces([&first, &second], &loads) else {
            return Vec::new();
        };
        let joints = self.model.declared_joints().zip(&found.reactions);
        let reactions = joints.filter_map(|(joint, &[x, y, _])| Some((self.joint(joint)?, [x, y])));
        reactions.collect()
    }

    /// What is constructed where it is, while this motor alone moves at a rate of 1, and forces are those at rest. Nothing where what that
    /// needs is not [prepared](Self::prepare).
    #[cfg(feature = "editor")]
    pub(crate) fn constructed(
        &self,
        constructions: &[Construction],
        centrodes: &[Centrodes],
        motor: usize,
        loads: &[f64],
    ) -> Option<Board> {
        let forced = self.with(Derived::Forces);
        let forced = forced.filter(|_| constructions.contains(&Construction::Forces));
        let compiled = forced.or_else(|| self.with(Derived::Rates))?;
        let id = self.model.motor_ids().nth(motor)?;
        let rest = vec![0.0; self.model.motors.len()];
        let mut alone = rest.clone();
        alone[motor] = 1.0;
        let loads = self.all_loads(loads);
        let mut at = quantity::Position::of(&self.position);
        at.rates = compiled.moving.as_ref().and_then(|program| {
            let mut machine = Mover::of(&self.model, program);
            machine.put_back(&self.position);
            machine.motion([&alone, &rest]).ok()
        });
        let program = compiled.forced.inverse_dynamics.as_ref();
        at.forces = program.and_then(|program| {
            let mut machine = Mover::of(&self.model, program);
            machine.put_back(&self.position);
            match machine.forces([&rest, &rest], &loads) {
                Ok(Forces::InverseDynamics(found)) => Some(found),
                _ => None,
            }
        });
        let subject = Surveyed { model: &self.model, compiled, loads: &loads };
        Some(Board::known(constructions, subject, centrodes, (at, id), self.bounds()))
    }

    /// The numbers of all loads; those that are not given are zero.
    fn all_loads(&self, given: &[f64]) -> Vec<f64> {
        let declared = self.model.actions.loads.iter();
        let count = declared.map(|load| load.kind.numbers()).sum();
        let mut loads = given.to_vec();
        loads.resize(count, 0.0);
        loads
    }

    /// The rates of all motors, and their second rates.
    fn all_rates(&self, rates: &Rates) -> [Vec<f64>; 2] {
        [&rates.first, &rates.second].map(|given| {
            let mut all = vec![0.0; self.model.motors.len()];
            for (value, rate) in all.iter_mut().zip(given) {
                *value = *rate;
            }
            all
        })
    }
}
