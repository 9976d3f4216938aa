//! Where a link is.

use crate::Scalar;
use nalgebra::{Complex, Isometry2, Translation2, Unit};

/// The pose of a link's frame in the scene: a unit complex number and a translation, so that no angle is formed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<T> {
    /// Cosine of the angle from the scene's x axis to the link's.
    pub cos: T,
    /// Sine of the same angle.
    pub sin: T,
    /// Abscissa of the link's origin, in scene units.
    pub x: T,
    /// Ordinate of the link's origin, in scene units.
    pub y: T,
}

impl<T: Scalar> Pose<T> {
    /// The pose of the ground.
    #[must_use]
    pub fn identity() -> Self {
        Self {
            cos: T::one(),
            sin: T::zero(),
            x: T::zero(),
            y: T::zero(),
        }
    }

    /// Carries a point of the link into the scene: from relative to absolute coordinates.
    #[must_use]
    pub fn apply(self, [x, y]: [T; 2]) -> [T; 2] {
        [
            self.x + self.cos * x - self.sin * y,
            self.y + self.sin * x + self.cos * y,
        ]
    }

    /// Turns a direction of the link into the scene.
    #[must_use]
    #[inline]
    pub(crate) fn turn(self, [x, y]: [T; 2]) -> [T; 2] {
        [self.cos * x - self.sin * y, self.sin * x + self.cos * y]
    }

    /// Carries a place in the scene into the link: from absolute to relative coordinates.
    #[must_use]
    pub fn relative(self, [x, y]: [T; 2]) -> [T; 2] {
        let [x, y] = [x - self.x, y - self.y];
        [self.cos * x + self.sin * y, self.cos * y - self.sin * x]
    }

    /// The same pose as a nalgebra isometry.
    #[must_use]
    pub fn isometry(self) -> Isometry2<T> {
        let rotation = Unit::new_unchecked(Complex::new(self.cos, self.sin));
        Isometry2::from_parts(Translation2::new(self.x, self.y), rotation)
    }
}

/// The pose of a link by its number, of which 0 is the ground and `n + 1` the moving link with the pose `poses[n]`.
pub(crate) fn pose_of<T: Scalar>(link: usize, poses: &[Pose<T>]) -> Option<Pose<T>> {
    match link.checked_sub(1) {
        None => Some(Pose::identity()),
        Some(moving) => poses.get(moving).copied(),
    }
}
