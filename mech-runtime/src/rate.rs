//! How fast links move.

use crate::{Pose, Scalar};

/// The velocity of a link, in the scene: how fast it turns, and how fast the origin of its frame moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Velocity<T> {
    /// Its angular velocity, in radians a unit of time.
    pub angular: T,
    /// The rate of the abscissa of its origin, in scene units a unit of time.
    pub x: T,
    /// The rate of the ordinate of its origin.
    pub y: T,
}

impl<T: Scalar> Velocity<T> {
    /// At rest.
    pub const ZERO: Self = Self {
        angular: T::ZERO,
        x: T::ZERO,
        y: T::ZERO,
    };

    /// The velocity of a point of the link, given in its frame, when the link is at `pose`.
    #[must_use]
    #[inline]
    pub fn of_point(self, pose: Pose<T>, point: [T; 2]) -> [T; 2] {
        let [x, y] = pose.turn(point);
        [self.x - self.angular * y, self.y + self.angular * x]
    }
}

/// The acceleration of a link, in the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Acceleration<T> {
    /// Its angular acceleration, in radians a squared unit of time.
    pub angular: T,
    /// The second rate of the abscissa of the origin of its frame, in scene units a squared unit of time.
    pub x: T,
    /// The second rate of the ordinate of its origin.
    pub y: T,
}

impl<T: Scalar> Acceleration<T> {
    /// At rest.
    pub const ZERO: Self = Self {
        angular: T::ZERO,
        x: T::ZERO,
        y: T::ZERO,
    };

    /// The acceleration of a point of the link, given in its frame, when the link is at `pose` and turns at this angular
    /// velocity: tangential and centripetal.
    #[must_use]
    #[inline]
    pub fn of_point(self, pose: Pose<T>, angular_velocity: T, point: [T; 2]) -> [T; 2] {
        let ([x, y], square) = (pose.turn(point), angular_velocity * angular_velocity);
        [
            self.x - self.angular * y - square * x,
            self.y + self.angular * x - square * y,
        ]
    }
}
