//! All that is known where a mechanism is.

use crate::motion::PlaneMotion;
use mech_compiler::Compiled;
use mech_compiler::model::{LinkId, MotorId, Rate};
use mech_compiler::program::LinkRates;
use mech_compiler::program::{self, Inertia, InverseDynamics};
use mech_runtime::Pose;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// All that is known where a mechanism is.
#[derive(Default)]
pub(crate) struct Position {
    /// The values of the motors, whole turns included.
    motors: Vec<f64>,
    poses: Vec<[f64; 4]>,
    state: Vec<f64>,
    pub(crate) rates: Option<LinkRates<f64>>,
    /// The rates for which forces are measured, if masses are asked for.
    pub(super) pushed: Option<LinkRates<f64>>,
    /// The rates if one motor alone moves, at a rate of 1: of the motors that are asked for.
    pub(super) influences: BTreeMap<MotorId, LinkRates<f64>>,
    /// The torques or forces of the motors.
    pub(super) torques: Option<Vec<f64>>,
    pub(crate) forces: Option<InverseDynamics<f64>>,
}

impl Position {
    /// A position of a machine, without rates and forces.
    pub(crate) fn of(at: &program::Position<f64>) -> Self {
        let motors = at.motors.iter().zip(&at.turns);
        Self {
            motors: motors.map(|(value, turns)| value + TAU * f64::from(*turns)).collect(),
            poses: at.poses.clone(),
            state: at.state.clone(),
            ..Self::default()
        }
    }

    /// The same place, with other rates and without forces.
    pub(super) fn with_rates(&self, rates: LinkRates<f64>) -> Self {
        Self {
            rates: Some(rates),
            motors: self.motors.clone(),
            poses: self.poses.clone(),
            state: self.state.clone(),
            ..Self::default()
        }
    }

    /// The value of a motor by its number.
    pub(super) fn motor(&self, number: usize) -> Option<f64> {
        self.motors.get(number).copied()
    }

    /// A number of the state.
    pub(super) fn state(&self, number: usize) -> Option<f64> {
        self.state.get(number).copied()
    }

    /// The pose of a link.
    pub(crate) fn pose(&self, compiled: &Compiled, link: LinkId) -> Option<Pose<f64>> {
        if link == LinkId::GROUND {
            return Some(Pose::identity());
        }
        let place = compiled.program.place_of(link)?;
        self.poses.get(place).copied().map(Pose::from)
    }

    /// The rates of a link, of this order: of its angle, and of x and y of its origin.
    pub(crate) fn rate(&self, compiled: &Compiled, link: LinkId, rate: Rate) -> Option<[f64; 3]> {
        if link == LinkId::GROUND {
            return Some([0.0; 3]);
        }
        let place = compiled.program.place_of(link)?;
        let rates = self.rates.as_ref()?;
        let all = match rate {
            Rate::Velocity => &rates.velocities,
            Rate::Acceleration => rates.accelerations.as_ref()?,
        };
        all.get(place).copied()
    }

    /// The velocity or the acceleration of that point of a link which is at a place in the scene.
    pub(crate) fn vector(
        &self,
        compiled: &Compiled,
        link: LinkId,
        place: [f64; 2],
        rate: Rate,
    ) -> Option<[f64; 2]> {
        let pose = self.pose(compiled, link)?;
        let [x, y] = [place[0] - pose.x, place[1] - pose.y];
        let [turning, along_x, along_y] = self.rate(compiled, link, rate)?;
        let centripetal = match rate {
            Rate::Acceleration => self.rate(compiled, link, Rate::Velocity)?[0].powi(2),
            Rate::Velocity => 0.0,
        };
        Some([along_x - turning * y - centripetal * x, along_y + turning * x - centripetal * y])
    }

    /// The motion of a link.
    pub(crate) fn motion(&self, compiled: &Compiled, link: LinkId) -> Option<PlaneMotion> {
        let pose = self.pose(compiled, link)?;
        let rates = self.rate(compiled, link, Rate::Velocity)?;
        Some(PlaneMotion::new(rates, pose))
    }

    /// The angle of a link in the scene, between −π and π.
    pub(super) fn heading(&self, compiled: &Compiled, link: LinkId) -> Option<f64> {
        let pose = self.pose(compiled, link)?;
        Some(pose.sin.atan2(pose.cos))
    }
}

/// Computes the torques or forces of motors with these second rates: those that accelerate everything, less those that act already.
pub(super) fn torques(inertia: &Inertia<f64>, second: &[f64]) -> Vec<f64> {
    let rows = inertia.matrix.iter().zip(&inertia.drive);
    let torque = |(row, drive): (&Vec<f64>, &f64)| {
        let parts = row.iter().zip(second);
        parts.map(|(mass, rate)| mass * rate).sum::<f64>() - drive
    };
    rows.map(torque).collect()
}
