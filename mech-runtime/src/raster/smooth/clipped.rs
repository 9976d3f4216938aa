//! The sides of any outline, within some rows.

use super::cover::Cover;
use super::side::Side;
use crate::raster::fixed;
use crate::{Real, Scalar};
use core::ops::Range;

/// An outline that can be seen.
pub(super) struct Clipped<T> {
    last: [T; 2],
    rows: Range<usize>,
}

impl<T: Scalar> Clipped<T> {
    /// An outline in a picture of so many rows; `None` if it has no corner, or one that is not finite.
    pub(super) fn new(
        corners: &(impl Iterator<Item = [T; 2]> + Clone),
        height: usize,
    ) -> Option<Self> {
        let mut extent = None;
        let mut last = [T::ZERO; 2];
        for [x, y] in corners.clone() {
            if !(Real::is_finite(x) && Real::is_finite(y)) {
                return None;
            }
            let (high, low) = extent.unwrap_or((y, y));
            extent = Some((high.min(y), Real::max(low, y)));
            last = [x, y];
        }
        let (high, low) = extent?;
        let rows = fixed::rows_touching([high, low], height);
        Some(Self { last, rows })
    }

    /// The rows in which it is seen.
    pub(super) fn rows(&self) -> Range<usize> {
        self.rows.clone()
    }

    /// Adds what it covers in some rows, of which this is the first.
    pub(super) fn cover<G: AsRef<[f32]> + AsMut<[f32]>>(
        &self,
        corners: &(impl Iterator<Item = [T; 2]> + Clone),
        covers: &mut [Cover<G>],
        top: usize,
    ) {
        let mut tail = self.last;
        for head in corners.clone() {
            if tail[1] < head[1] {
                side(tail, head, 1.0, covers, top);
            } else if head[1] < tail[1] {
                side(head, tail, -1.0, covers, top);
            }
            tail = head;
        }
    }
}

/// Adds a side, from its upper end to its lower one.
fn side<T: Scalar, G: AsRef<[f32]> + AsMut<[f32]>>(
    upper: [T; 2],
    lower: [T; 2],
    sign: f32,
    covers: &mut [Cover<G>],
    top: usize,
) {
    let rows = fixed::rows_touching([upper[1], lower[1]], top + covers.len());
    let first = rows.start.max(top);
    let side = Side::new(upper, lower);
    let mut y = Real::max(fixed::border(first), upper[1]);
    let mut x = side.at(y);
    let covers = covers.iter_mut().skip(first - top);
    for (row, cover) in (first..rows.end).zip(covers) {
        let end = fixed::border::<T>(row + 1).min(lower[1]);
        let next = side.at(end);
        let (start, stop) = (x.to_f32(), next.to_f32());
        cover.touch(start, stop);
        cover.add(start, stop, sign * (end - y).to_f32());
        (x, y) = (next, end);
    }
}
