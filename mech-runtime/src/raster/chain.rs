//! Sides that lead down from the highest corner of a polygon, one after the other; and whether there are such.

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

/// How often the corners of a polygon change between going down and going up: twice, if there are two chains.
pub(super) struct Ways<N> {
    first: Option<N>,
    last: Option<N>,
    first_way: Option<bool>,
    way: Option<bool>,
    turns: usize,
}

impl<N: Copy + PartialOrd> Ways<N> {
    pub(super) const fn new() -> Self {
        Self {
            first: None,
            last: None,
            first_way: None,
            way: None,
            turns: 0,
        }
    }

    /// Goes to the next corner, which is so far down.
    #[inline]
    pub(super) fn go(&mut self, depth: N) {
        let Some(last) = self.last.replace(depth) else {
            self.first = Some(depth);
            return;
        };
        if depth != last {
            let way = Some(depth > last);
            self.turns += usize::from(self.way.is_some() && self.way != way);
            self.first_way = self.first_way.or(way);
            self.way = way;
        }
    }

    /// All the way round.
    pub(super) fn turns(mut self) -> usize {
        if let Some(first) = self.first {
            self.go(first);
        }
        self.turns + usize::from(self.way != self.first_way)
    }
}
