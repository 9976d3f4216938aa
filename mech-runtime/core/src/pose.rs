//! Poses of links.

use crate::Real;
use nalgebra::{Complex, Isometry2, Translation2, Unit};

/// The pose of a link's frame in the scene: a direction of length one, and a translation in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<T> {
    /// The cosine of the angle from the scene's x axis to the link's.
    pub cos: T,
    /// The sine of the same angle.
    pub sin: T,
    /// The x coordinate of the link's origin, in scene units.
    pub x: T,
    /// The y coordinate of the link's origin, in scene units.
    pub y: T,
}

impl<T: Real> Pose<T> {
    /// The pose of the ground.
    #[must_use]
    pub fn identity() -> Self {
        [T::ONE, T::ZERO, T::ZERO, T::ZERO].into()
    }

    /// The pose of a link by its number, of which 0 is the ground and `n + 1` the moving link with the pose `poses[n]`. `None` if there are
    /// not so many.
    #[must_use]
    pub fn of_link(link: usize, poses: &[Self]) -> Option<Self> {
        match link.checked_sub(1) {
            None => Some(Self::identity()),
            Some(moving) => poses.get(moving).copied(),
        }
    }

    /// The place in the scene of a point of the link, in scene units.
    #[must_use]
    pub fn apply(self, [x, y]: [T; 2]) -> [T; 2] {
        [self.x + self.cos * x - self.sin * y, self.y + self.sin * x + self.cos * y]
    }

    /// The direction in the scene of a direction of the link.
    #[must_use]
    #[inline]
    pub fn turn(self, [x, y]: [T; 2]) -> [T; 2] {
        [self.cos * x - self.sin * y, self.sin * x + self.cos * y]
    }

    /// The point of the link that is at a place in the scene, in scene units: the inverse of [`apply`](Self::apply).
    #[must_use]
    pub fn relative(self, [x, y]: [T; 2]) -> [T; 2] {
        let [x, y] = [x - self.x, y - self.y];
        [self.cos * x + self.sin * y, self.cos * y - self.sin * x]
    }

    /// The same pose as a nalgebra isometry.
    #[must_use]
    pub fn isometry(self) -> Isometry2<T> {
        Isometry2 {
            rotation: Unit::new_unchecked(Complex::new(self.cos, self.sin)),
            translation: Translation2::new(self.x, self.y),
        }
    }
}

/// Of the cosine, the sine, x and y.
impl<T> From<[T; 4]> for Pose<T> {
    fn from([cos, sin, x, y]: [T; 4]) -> Self {
        Self { cos, sin, x, y }
    }
}

/// The cosine, the sine, x and y.
impl<T> From<Pose<T>> for [T; 4] {
    fn from(pose: Pose<T>) -> Self {
        [pose.cos, pose.sin, pose.x, pose.y]
    }
}

impl<T: Real> From<Pose<T>> for Isometry2<T> {
    fn from(pose: Pose<T>) -> Self {
        pose.isometry()
    }
}

/// The pose of an isometry, with the same bits.
impl<T: Real> From<Isometry2<T>> for Pose<T> {
    fn from(isometry: Isometry2<T>) -> Self {
        let Isometry2 { rotation, translation } = isometry;
        Self {
            cos: rotation.as_ref().re,
            sin: rotation.as_ref().im,
            x: translation.vector[0],
            y: translation.vector[1],
        }
    }
}
