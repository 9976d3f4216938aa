//! The functions that generated code uses, and the coordinates of joints.

use crate::{Pose, Real, Scalar};

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

/// The square root.
#[inline]
pub fn sqrt<T: Scalar>(value: T) -> T {
    Real::sqrt(value)
}

/// The greater of two numbers: the second, if they are not ordered.
#[inline]
pub fn greater<T: Scalar>(a: T, b: T) -> T {
    Real::max(a, b)
}

/// The nearest whole number, halves away from zero.
#[inline]
pub fn round<T: Scalar>(value: T) -> T {
    Real::round(value)
}

/// An axis in the scene: the pose of its link, its origin and its direction in the link's frame.
type Axis<T> = (Pose<T>, [T; 2], [T; 2]);

fn heading<T: Scalar>((pose, _, [x, y]): Axis<T>) -> [T; 2] {
    [pose.cos * x - pose.sin * y, pose.sin * x + pose.cos * y]
}

/// The coordinate of a revolute joint: the angle from one axis's direction to the other's, in radians.
pub fn angle<T: Scalar>(from: Axis<T>, to: Axis<T>) -> T {
    let ([a, b], [c, d]) = (heading(from), heading(to));
    atan2(a * d - b * c, a * c + b * d)
}

/// The coordinate of a prismatic joint: the way from one axis's origin to the other's, along the first.
pub fn slide<T: Scalar>(from: Axis<T>, to: Axis<T>) -> T {
    let ([a, b], [c, d]) = (from.0.apply(from.1), to.0.apply(to.1));
    let [x, y] = heading(from);
    (c - a) * x + (d - b) * y
}
