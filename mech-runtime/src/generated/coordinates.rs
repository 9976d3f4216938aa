//! The functions that generated code uses, and the coordinates of joints.

use crate::{Acceleration, Pose, Real, Scalar, Velocity};

/// The sine and the cosine of an angle in radians.
#[inline]
pub fn sin_cos<T: Scalar>(angle: T) -> (T, T) {
    Real::sin_cos(angle)
}

/// The angle of the vector (`x`, `y`), in radians.
#[inline]
pub fn atan2<T: Scalar>(y: T, x: T) -> T {
    Real::atan2(y, x)
}

/// e to a power.
#[inline]
pub fn exp<T: Scalar>(power: T) -> T {
    Real::exp(power)
}

/// The square root.
#[inline]
pub fn sqrt<T: Scalar>(value: T) -> T {
    Real::sqrt(value)
}

/// The greater of two numbers, or the second if one is NaN.
#[inline]
pub fn max<T: Scalar>(a: T, b: T) -> T {
    Real::max(a, b)
}

/// The nearest whole number, halves away from zero.
#[inline]
pub fn round<T: Scalar>(value: T) -> T {
    Real::round(value)
}

/// An axis in the scene: the pose of its link, its origin and its direction in the link's frame.
type Axis<T> = (Pose<T>, [T; 2], [T; 2]);

fn heading<T: Scalar>((pose, _, along): Axis<T>) -> [T; 2] {
    pose.turn(along)
}

/// The coordinate of a revolute joint: the angle from one axis's direction to the other's, in radians.
pub fn angle<T: Scalar>(from: Axis<T>, to: Axis<T>) -> T {
    let ([a, b], [c, d]) = (heading(from), heading(to));
    atan2(a * d - b * c, a * c + b * d)
}

/// The coordinate of a prismatic joint: the distance from one axis's origin to the other's, along the first.
pub fn slide<T: Scalar>(from: Axis<T>, to: Axis<T>) -> T {
    let ([a, b], [c, d]) = (from.0.apply(from.1), to.0.apply(to.1));
    let [x, y] = heading(from);
    (c - a) * x + (d - b) * y
}

/// The rate of the coordinate of a prismatic joint.
pub fn slide_rate<T: Scalar>(
    from: Axis<T>,
    at_start: Velocity<T>,
    to: Axis<T>,
    at_end: Velocity<T>,
) -> T {
    let ([x, y], [p, q]) = (heading(from), span(from, to));
    let ([a, b], [c, d]) = (at_start.of_point(from.0, from.1), at_end.of_point(to.0, to.1));
    (c - a) * x + (d - b) * y + at_start.angular * (q * x - p * y)
}

/// The second rate of the coordinate of a prismatic joint.
pub fn slide_acceleration<T: Scalar>(
    from: Axis<T>,
    (start_rate, start): (Velocity<T>, Acceleration<T>),
    to: Axis<T>,
    (end_rate, end): (Velocity<T>, Acceleration<T>),
) -> T {
    let ([x, y], [p, q]) = (heading(from), span(from, to));
    let turning = start_rate.angular;
    let ([a, b], [c, d]) = (start_rate.of_point(from.0, from.1), end_rate.of_point(to.0, to.1));
    let ([e, f], [g, h]) =
        (start.of_point(from.0, turning, from.1), end.of_point(to.0, end_rate.angular, to.1));
    let across = (d - b) * x - (c - a) * y;
    (g - e) * x + (h - f) * y + turning * (across + across) + start.angular * (q * x - p * y)
        - turning * turning * (p * x + q * y)
}

/// The vector from the origin of an axis to that of another, in the scene.
fn span<T: Scalar>(from: Axis<T>, to: Axis<T>) -> [T; 2] {
    let ([a, b], [c, d]) = (from.0.apply(from.1), to.0.apply(to.1));
    [c - a, d - b]
}
