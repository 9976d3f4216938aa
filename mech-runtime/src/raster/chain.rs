//! Sides that lead down from the highest corner of a polygon, one after the other.

use super::edge::Edge;
use crate::Scalar;

/// One of the two ways down.
pub(super) struct Chain<'c, T, F> {
    corner: &'c F,
    count: usize,
    /// The number of the corner up to which it has gone, and that corner.
    index: usize,
    place: [T; 2],
    is_onward: bool,
    /// How many sides are left.
    left: usize,
    height: usize,
    side: Option<Edge>,
}

impl<'c, T: Scalar, F: Fn(usize) -> [T; 2]> Chain<'c, T, F> {
    /// Begins at a corner, and goes from number to number onward or back, in a picture of so many rows.
    pub(super) fn new(
        corner: &'c F,
        count: usize,
        highest: usize,
        is_onward: bool,
        height: usize,
    ) -> Self {
        Self {
            corner,
            count,
            index: highest,
            place: corner(highest),
            is_onward,
            left: count,
            height,
            side: None,
        }
    }

    /// The side that crosses a row. Rows are asked for from the top.
    pub(super) fn side_at(&mut self, row: usize) -> Option<Edge> {
        while self.side.is_none_or(|side| side.end <= row) {
            self.left = self.left.checked_sub(1)?;
            let last = self.count - 1;
            self.index = match (self.is_onward, self.index) {
                (true, index) if index == last => 0,
                (true, index) => index + 1,
                (false, 0) => last,
                (false, index) => index - 1,
            };
            let next = (self.corner)(self.index);
            self.side = Edge::new(self.place, next, self.height);
            self.place = next;
        }
        self.side
    }
}
