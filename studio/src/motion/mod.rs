//! The motion that a command gives the motors of a mechanism.

mod drive;
mod lead;
mod mover;
mod obstacle;
mod paths;
mod reach;
mod rest;
mod setting;
mod trajectory;

pub(crate) use drive::{Drive, Moment};
pub(crate) use lead::Goal;
pub(crate) use mover::{Mover, Ready, in_precision, place_of};
pub(crate) use obstacle::{joints_in_the_way, motor_name, obstacle};
pub(crate) use paths::Paths;
pub(crate) use reach::{Basis, Reach};
pub(crate) use rest::find_rest;
pub(crate) use setting::{Setting, Span, Typed, posed, range_of, read_value, show_value, shown};

use mech_runtime::Pose;

/// Links whose rates differ by less than this part of the greater turn as one.
const ROUNDING: f64 = 1e-12;

/// How a link moves: its angular velocity, and the velocity of what of it is at the scene's origin.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PlaneMotion {
    turning: f64,
    origin: [f64; 2],
}

impl PlaneMotion {
    /// The motion of a link at a pose, from the rates of its angle and of its own origin.
    pub(crate) fn new([turning, x, y]: [f64; 3], pose: Pose<f64>) -> Self {
        Self { turning, origin: [x + turning * pose.y, y - turning * pose.x] }
    }

    /// The place in the scene at which two links move as one; none if they turn at the same rate, as it is at infinity then.
    pub(crate) fn centre(self, other: Self) -> Option<[f64; 2]> {
        let turning = other.turning - self.turning;
        let fastest = self.turning.abs().max(other.turning.abs());
        let [x, y] = [0, 1].map(|part| other.origin[part] - self.origin[part]);
        (turning.abs() > ROUNDING * fastest).then(|| [-y / turning, x / turning])
    }
}
