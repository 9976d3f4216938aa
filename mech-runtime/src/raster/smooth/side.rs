//! One side of an outline.

use crate::{Real, Scalar};

/// The greatest distance, in pixels. Places farther away are moved there.
const FAR: i32 = 1_000_000_000;

/// A side of an outline that is not level, from its upper end down.
#[derive(Clone, Copy)]
pub(super) struct Side<T> {
    /// The upper end.
    x: T,
    pub(super) start: T,
    /// The ordinate at which it ends.
    pub(super) end: T,
    slope: T,
    left: T,
    right: T,
}

impl<T: Scalar> Side<T> {
    /// The side between two corners, of which the first is above the other.
    #[inline]
    pub(super) fn new(upper: [T; 2], lower: [T; 2]) -> Self {
        let limit = <T as Real>::from_i32(FAR);
        let near = |x: T| Real::max(x, -limit).min(limit);
        let [from, to] = [near(upper[0]), near(lower[0])];
        let (left, right) = if from <= to { (from, to) } else { (to, from) };
        Self {
            x: from,
            start: upper[1],
            end: lower[1],
            slope: (to - from) / (lower[1] - upper[1]),
            left,
            right,
        }
    }

    /// Its abscissa at an ordinate between its ends.
    #[inline]
    pub(super) fn at(&self, y: T) -> T {
        // Within the side also where its slope is beyond all numbers.
        Real::max(self.x + (y - self.start) * self.slope, self.left).min(self.right)
    }
}
