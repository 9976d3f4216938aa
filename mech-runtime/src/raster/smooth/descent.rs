//! One of the two ways down around a polygon.

use super::cover::Cover;
use super::side::Side;
use crate::{Real, Scalar};

/// Sides that lead down from the highest corner of a polygon, one after the other.
pub(super) struct Descent<'c, T, F> {
    corner: &'c F,
    count: usize,
    /// The number of the corner up to which it has gone, and that corner.
    index: usize,
    place: [T; 2],
    is_onward: bool,
    /// How many sides are left.
    left: usize,
    side: Option<Side<T>>,
}

impl<'c, T: Scalar, F: Fn(usize) -> [T; 2]> Descent<'c, T, F> {
    /// Begins at a corner, and goes from number to number onward or back.
    pub(super) fn new(corner: &'c F, count: usize, highest: usize, is_onward: bool) -> Self {
        Self {
            corner,
            count,
            index: highest,
            place: corner(highest),
            is_onward,
            left: count,
            side: None,
        }
    }

    /// The side that leads on from an ordinate, or begins below it. Ordinates are asked for from the top.
    #[inline]
    pub(super) fn side_from(&mut self, y: T) -> Option<Side<T>> {
        while self.side.is_none_or(|side| side.end <= y) {
            self.left = self.left.checked_sub(1)?;
            let last = self.count - 1;
            self.index = match (self.is_onward, self.index) {
                (true, index) if index == last => 0,
                (true, index) => index + 1,
                (false, 0) => last,
                (false, index) => index - 1,
            };
            let next = (self.corner)(self.index);
            if next[1] < self.place[1] {
                // It has arrived at the bottom.
                self.left = 0;
                return None;
            }
            self.side = (self.place[1] < next[1]).then(|| Side::new(self.place, next));
            self.place = next;
        }
        self.side
    }

    /// Adds what it covers between the borders of a row, to the right of it, with the sign of its way round.
    pub(super) fn cover<const W: usize>(&mut self, [top, bottom]: [T; 2], cover: &mut Cover<W>) {
        let sign = if self.is_onward { 1.0 } else { -1.0 };
        let mut y = top;
        while y < bottom
            && let Some(side) = self.side_from(y)
        {
            y = Real::max(y, side.start);
            if bottom <= y {
                return;
            }
            let end = bottom.min(side.end);
            let [from, to] = [y, end].map(|y| side.at(y).to_f32());
            cover.touch(from, to);
            cover.add(from, to, sign * (end - y).to_f32());
            y = end;
        }
    }
}
