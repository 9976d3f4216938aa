//! Velocities and accelerations of links.

use crate::{Pose, Scalar};

/// The velocity of a link in the scene: the angular velocity, and the velocity of the origin of its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Velocity<T> {
    /// The angular velocity, in radians per unit of time.
    pub angular: T,
    /// The x component of the velocity of its origin, in scene units per unit of time.
    pub x: T,
    /// The y component of the velocity of its origin.
    pub y: T,
}

impl<T: Scalar> Velocity<T> {
    /// Zero.
    pub const ZERO: Self = Self { angular: T::ZERO, x: T::ZERO, y: T::ZERO };

    /// The velocity of a point of the link when the link is at `pose`. The point is given in the link's frame.
    #[must_use]
    #[inline]
    pub fn of_point(self, pose: Pose<T>, point: [T; 2]) -> [T; 2] {
        let [x, y] = pose.turn(point);
        [self.x - self.angular * y, self.y + self.angular * x]
    }
}

/// The acceleration of a link in the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Acceleration<T> {
    /// The angular acceleration, in radians per squared unit of time.
    pub angular: T,
    /// The x component of the acceleration of its origin, in scene units per squared unit of time.
    pub x: T,
    /// The y component of the acceleration of its origin.
    pub y: T,
}

impl<T: Scalar> Acceleration<T> {
    /// Zero.
    pub const ZERO: Self = Self { angular: T::ZERO, x: T::ZERO, y: T::ZERO };

    /// The acceleration of a point of the link, tangential and centripetal, when the link is at `pose` and turns at this angular velocity.
    /// The point is given in the link's frame.
    #[must_use]
    #[inline]
    pub fn of_point(self, pose: Pose<T>, angular_velocity: T, point: [T; 2]) -> [T; 2] {
        let ([x, y], square) = (pose.turn(point), angular_velocity * angular_velocity);
        [self.x - self.angular * y - square * x, self.y + self.angular * x - square * y]
    }
}
