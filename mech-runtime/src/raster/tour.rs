//! The sides of a polygon, one after the other.

use crate::Scalar;

/// A tour around a polygon from one of its corners.
pub(super) struct Tour<'c, T, F> {
    corner: &'c F,
    count: usize,
    /// The number of the corner that it has reached, and that corner.
    index: usize,
    place: [T; 2],
    is_onward: bool,
    /// The number of sides to come.
    left: usize,
}

impl<'c, T: Scalar, F: Fn(usize) -> [T; 2]> Tour<'c, T, F> {
    /// A tour from a corner, in rising or falling order of the numbers.
    pub(super) fn new(corner: &'c F, count: usize, first: usize, is_onward: bool) -> Self {
        Self { corner, count, index: first, place: corner(first), is_onward, left: count }
    }

    pub(super) const fn is_onward(&self) -> bool {
        self.is_onward
    }

    /// The next side, from where it has come to the next corner; `None` after once round.
    #[inline]
    pub(super) fn next_side(&mut self) -> Option<[[T; 2]; 2]> {
        self.left = self.left.checked_sub(1)?;
        let last = self.count - 1;
        self.index = match (self.is_onward, self.index) {
            (true, index) if index == last => 0,
            (true, index) => index + 1,
            (false, 0) => last,
            (false, index) => index - 1,
        };
        let from = core::mem::replace(&mut self.place, (self.corner)(self.index));
        Some([from, self.place])
    }
}
