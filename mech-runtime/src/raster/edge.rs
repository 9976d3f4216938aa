//! One side of a polygon, row by row.

use super::fixed::{self, FAR, HALF};
use crate::{Real, Scalar};
use core::ops::Range;

/// A side of a polygon: in each row that it crosses, the first pixel to its right.
///
/// It is computed from its upper end to its lower, and from its first row in the picture. Neither its sense nor the painted part of the
/// picture matters, so two shapes that share a side find the same pixels.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    /// The rows of the picture that it crosses.
    pub(super) first: usize,
    pub(super) end: usize,
    /// The crossing with the first row. The pixel that holds it is the first whose centre is not on its left.
    at: i64,
    /// The step of the crossing from row to row.
    step: i64,
    /// Whether it was declared downwards.
    pub(super) falls: bool,
}

impl Edge {
    /// The side between two corners in pixels, neither of which is far away, in a picture of so many rows; `None` if it crosses
    /// none.
    #[inline]
    pub(super) fn new<T: Scalar>(tail: [T; 2], head: [T; 2], height: usize) -> Option<Self> {
        let falls = (tail[1], tail[0]) <= (head[1], head[0]);
        let (upper, lower) = if falls { (tail, head) } else { (head, tail) };
        let first = fixed::first_from(upper[1], height);
        let end = fixed::first_from(lower[1], height);
        if first >= end {
            return None;
        }
        let (run, drop) = (lower[0] - upper[0], lower[1] - upper[1]);
        // Multiplied before it is divided: exact wherever the result is a number that can be written down.
        let at = upper[0] + (fixed::center::<T>(first) - upper[1]) * run / drop;
        let [left, right] =
            if run >= T::ZERO { [upper[0], lower[0]] } else { [lower[0], upper[0]] };
        let at = Real::max(at, left).min(right);
        Some(Self {
            first,
            end,
            at: Scalar::to_fixed(at) + (HALF - 1),
            step: Scalar::to_fixed(run / drop),
            falls,
        })
    }

    /// The crossing with a row, moved right by half a pixel. The pixel that holds it is the first on its right.
    #[inline]
    pub(super) fn at(&self, row: usize) -> i64 {
        #[expect(clippy::cast_possible_wrap, reason = "rows of a picture")]
        let down = row as i64 - self.first as i64;
        // A side that crosses one row only may be so flat that its step is beyond all numbers: it is not taken.
        self.at.wrapping_add(self.step.wrapping_mul(down))
    }

    /// The step of the crossing from row to row.
    #[inline]
    pub(super) fn step(&self) -> i64 {
        self.step
    }
}

/// Whether a corner is too far away for an [`Edge`].
#[inline]
pub(super) fn is_far<T: Scalar>(x: T) -> bool {
    Real::abs(x) > <T as Real>::from_i32(FAR)
}

/// The side between two corners in pixels, wherever these are. A side too far to the left or right becomes upright there, where nobody
/// sees it.
pub(super) fn sides<T: Scalar>(
    tail: [T; 2],
    head: [T; 2],
    height: usize,
) -> impl Iterator<Item = Edge> {
    let limit = <T as Real>::from_i32(FAR);
    let mut parts = [None; 3];
    if is_far(tail[0]) || is_far(head[0]) {
        // One order of the ends, so that the polygon on the other side does the very same.
        let falls = (tail[1], tail[0]) <= (head[1], head[0]);
        let (upper, lower) = if falls { (tail, head) } else { (head, tail) };
        let inside = |x: T| Real::max(-limit, x).min(limit);
        let crossing = |x: T| {
            let y = upper[1] + (x - upper[0]) / (lower[0] - upper[0]) * (lower[1] - upper[1]);
            Real::max(upper[1], y).min(lower[1])
        };
        let [enters, leaves] = [upper[0], lower[0]].map(|x| {
            let x = inside(x);
            let is_cut = lower[0] != upper[0];
            (x, is_cut.then(|| crossing(x)))
        });
        let first = [enters.0, enters.1.unwrap_or(upper[1])];
        let last = [leaves.0, leaves.1.unwrap_or(lower[1])];
        let mut corners = [[first[0], upper[1]], first, last, [last[0], lower[1]]];
        if !falls {
            corners.reverse();
        }
        for (part, ends) in parts.iter_mut().zip(corners.windows(2)) {
            if let [tail, head] = *ends {
                *part = Edge::new(tail, head, height);
            }
        }
    } else {
        parts[0] = Edge::new(tail, head, height);
    }
    parts.into_iter().flatten()
}

/// The rows of a picture whose centres lie between two ordinates.
pub(super) fn rows<T: Scalar>([high, low]: [T; 2], height: usize) -> Range<usize> {
    fixed::first_from(high, height)..fixed::first_from(low, height)
}
