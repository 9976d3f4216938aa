//! Poses of links.

use crate::Scalar;
use nalgebra::Isometry2;

/// The pose of a link's frame in the scene: a direction of length one, and a translation in scene units.
///
/// `From` converts it to nalgebra's isometry and back. Places and directions, which are arrays here, convert to points and vectors:
///
/// ```
/// use mech_runtime::{Isometry2, Point2, Pose};
///
/// let pose = Pose { cos: 0.0, sin: 1.0, x: 2.0, y: 3.0 };
/// let isometry = Isometry2::from(pose);
/// assert_eq!(Pose::from(isometry), pose);
/// let point = Point2::new(1.0, 0.0);
/// assert_eq!(Point2::from(pose.apply(point.into())), Point2::new(2.0, 4.0));
/// assert_eq!(isometry * point, Point2::new(2.0, 4.0));
/// ```
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

impl<T: Scalar> Pose<T> {
    /// The pose of the ground.
    #[must_use]
    pub fn identity() -> Self {
        Self {
            cos: T::ONE,
            sin: T::ZERO,
            x: T::ZERO,
            y: T::ZERO,
        }
    }

    /// The place in the scene of a point of the link, in scene units.
    #[must_use]
    pub fn apply(self, [x, y]: [T; 2]) -> [T; 2] {
        [
            self.x + self.cos * x - self.sin * y,
            self.y + self.sin * x + self.cos * y,
        ]
    }

    /// The direction in the scene of a direction of the link.
    #[must_use]
    #[inline]
    pub(crate) fn turn(self, [x, y]: [T; 2]) -> [T; 2] {
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
        T::isometry([self.cos, self.sin], [self.x, self.y])
    }
}

impl<T: Scalar> From<Pose<T>> for Isometry2<T> {
    fn from(pose: Pose<T>) -> Self {
        pose.isometry()
    }
}

/// The pose of an isometry, with the same bits.
impl<T: Scalar> From<Isometry2<T>> for Pose<T> {
    fn from(isometry: Isometry2<T>) -> Self {
        let Isometry2 {
            rotation,
            translation,
        } = isometry;
        Self {
            cos: rotation.as_ref().re,
            sin: rotation.as_ref().im,
            x: translation.vector[0],
            y: translation.vector[1],
        }
    }
}

/// The pose of a link by its number, of which 0 is the ground and `n + 1` the moving link with the pose `poses[n]`.
pub(crate) fn pose_of<T: Scalar>(link: usize, poses: &[Pose<T>]) -> Option<Pose<T>> {
    match link.checked_sub(1) {
        None => Some(Pose::identity()),
        Some(moving) => poses.get(moving).copied(),
    }
}
