//! Polygons whose corners go down once and up once, as those of every convex polygon do.

use super::Soft;
use super::cover::Cover;
use super::flank::{self, Flank};
use super::side::Side;
use crate::raster::chain::Directions;
use crate::raster::crossings::Rule;
use crate::raster::fixed;
use crate::raster::memory::{Grid, Memory};
use crate::raster::tour::Tour;
use crate::{Real, Scalar};
use core::ops::Range;

/// Such a polygon, of which something can be seen.
pub(super) struct Simple<'c, F> {
    corner: &'c F,
    count: usize,
    /// The number of a corner above which there is none.
    highest: usize,
    rows: Range<usize>,
}

impl<'c, F> Simple<'c, F> {
    /// In a picture of so many rows; `None` if it is another polygon, or has a corner that is not finite.
    pub(super) fn new<T: Scalar>(corner: &'c F, count: usize, height: usize) -> Option<Self>
    where
        F: Fn(usize) -> [T; 2],
    {
        let mut extent: Option<[T; 2]> = None;
        let mut highest = 0;
        let mut directions = Directions::new();
        for index in 0..count {
            let [x, y] = corner(index);
            if !(Real::is_finite(x) && Real::is_finite(y)) {
                return None;
            }
            let [high, low] = extent.unwrap_or([y; 2]);
            if y < high {
                highest = index;
            }
            extent = Some([high.min(y), Real::max(low, y)]);
            directions.add(y);
        }
        let rows = fixed::rows_touching(extent?, height);
        (directions.turns() <= 2).then_some(Self { corner, count, highest, rows })
    }

    /// Paints it row by row.
    pub(super) fn paint<T: Scalar, M: Memory>(&self, picture: &mut Soft<M>, paint: [u8; 4])
    where
        F: Fn(usize) -> [T; 2],
    {
        let descent = |is_onward| {
            let tour = Tour::new(self.corner, self.count, self.highest, is_onward);
            Descent::new(tour)
        };
        let mut descents = [descent(true), descent(false)];
        let mut row = self.rows.start;
        while row < self.rows.end {
            let whole = row..whole_until(&mut descents, row, self.rows.end);
            if whole.is_empty() {
                by_cover(picture, &mut descents, row, paint);
                row += 1;
            } else {
                row = whole.end;
                between_sides(picture, &mut descents, whole, paint);
            }
        }
    }
}

/// The end of the rows from this one on that one side each crosses from border to border.
fn whole_until<T: Scalar, F: Fn(usize) -> [T; 2]>(
    descents: &mut [Descent<'_, T, F>; 2],
    row: usize,
    end: usize,
) -> usize {
    let top = fixed::border(row);
    descents.iter_mut().fold(end, |end, descent| {
        let side = descent.side_from(top).filter(|side| side.start <= top);
        side.map_or(row, |side| fixed::border_above(side.end, end))
    })
}

/// Paints rows that one side each crosses from border to border.
fn between_sides<T: Scalar, F: Fn(usize) -> [T; 2], M: Memory>(
    picture: &mut Soft<M>,
    descents: &mut [Descent<'_, T, F>; 2],
    rows: Range<usize>,
    paint: [u8; 4],
) {
    #[expect(clippy::cast_precision_loss, reason = "no picture is 2²⁴ pixels wide")]
    let width = picture.width() as f32;
    let mut y = fixed::border::<T>(rows.start);
    let [one, other] = descents;
    let (Some(one), Some(other)) = (one.side_from(y), other.side_from(y)) else {
        return;
    };
    let at = |y: T| [one.at(y).to_f32(), other.at(y).to_f32()];
    let mut from = at(y);
    for row in rows {
        y += T::ONE;
        let to = at(y);
        let one = Flank::new(from[0], to[0], width);
        let other = Flank::new(from[1], to[1], width);
        from = to;
        if let (Some(one), Some(other)) = (one, other)
            && let Some(pixels) = picture.pixels.row_mut(row)
            && flank::fill_between(pixels, [one, other], paint)
        {
            continue;
        }
        by_cover(picture, descents, row, paint);
    }
}

/// Paints a row by what the sides in it cover.
fn by_cover<T: Scalar, F: Fn(usize) -> [T; 2], M: Memory>(
    picture: &mut Soft<M>,
    descents: &mut [Descent<'_, T, F>; 2],
    row: usize,
    paint: [u8; 4],
) {
    let borders = [row, row + 1].map(fixed::border::<T>);
    let [cover, ..] = &mut picture.covers;
    for descent in descents {
        descent.cover(borders, cover);
    }
    // An area that is covered once is covered by either rule.
    picture.paint(row, 0, Rule::NonZero, paint);
}

/// Sides that lead down from the highest corner of a polygon, one after the other.
struct Descent<'c, T, F> {
    tour: Tour<'c, T, F>,
    side: Option<Side<T>>,
    has_arrived: bool,
}

impl<'c, T: Scalar, F: Fn(usize) -> [T; 2]> Descent<'c, T, F> {
    /// Goes down on a tour from the highest corner.
    pub(super) const fn new(tour: Tour<'c, T, F>) -> Self {
        Self { tour, side: None, has_arrived: false }
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
