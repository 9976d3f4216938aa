//! One of the two sides of a polygon, from the top to the bottom.

use super::cover::Cover;
use super::side::Side;
use crate::raster::tour::Tour;
use crate::{Real, Scalar};

/// Sides that lead down from the highest corner of a polygon, one after the other.
pub(super) struct Descent<'c, T, F> {
    tour: Tour<'c, T, F>,
    side: Option<Side<T>>,
    has_arrived: bool,
}

impl<'c, T: Scalar, F: Fn(usize) -> [T; 2]> Descent<'c, T, F> {
    /// Goes down on a tour from the highest corner.
    pub(super) const fn new(tour: Tour<'c, T, F>) -> Self {
        Self {
            tour,
            side: None,
            has_arrived: false,
        }
    }

    /// The side that leads on from an ordinate, or begins below it. Ordinates are asked for from the top.
    #[inline]
    pub(super) fn side_from(&mut self, y: T) -> Option<Side<T>> {
        while self.side.is_none_or(|side| side.end <= y) {
            if self.has_arrived {
                return None;
            }
            let [from, to] = self.tour.next_side()?;
            if to[1] < from[1] {
                self.has_arrived = true;
                return None;
            }
            self.side = (from[1] < to[1]).then(|| Side::new(from, to));
        }
        self.side
    }

    /// Adds what it covers to its right, between the borders of a row, with the sign of its sense.
    pub(super) fn cover<G: AsRef<[f32]> + AsMut<[f32]>>(
        &mut self,
        [top, bottom]: [T; 2],
        cover: &mut Cover<G>,
    ) {
        let sign = if self.tour.is_onward() { 1.0 } else { -1.0 };
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
