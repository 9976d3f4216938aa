//! Filled polygons, of any number of corners and by the even-odd rule.
//!
//! Each edge marks, in every row it crosses, the first pixel to its right; painting switches on and off at the marks.
//! Rows are taken eight at a time, one bit each, so that eight rows need `W` bytes of marks and one pass over the corners.
//! Two polygons with a common edge mark the same pixels along it, whichever way each goes round: no gap, no overlap.

use super::grid;
use crate::Scalar;
use core::ops::Range;

/// Rows in a band: as many as a mark has bits.
const BAND: usize = u8::BITS as usize;

/// Fills a polygon given in pixels.
pub(super) fn fill<T: Scalar, const W: usize>(
    rows: &mut [[u8; W]],
    corners: &(impl Iterator<Item = [T; 2]> + Clone),
    color: u8,
) {
    let mut extent = rows.len()..0;
    let mut last = None;
    for corner in corners.clone() {
        let [x, y] = corner;
        if !(x.is_finite() && y.is_finite()) {
            return;
        }
        let row = grid::first_from(y, rows.len());
        extent = extent.start.min(row)..extent.end.max(row);
        last = Some(corner);
    }
    let (Some(last), top) = (last, extent.start) else {
        return;
    };
    let Some(rows) = rows.get_mut(extent) else {
        return;
    };
    let mut band = Band::<W>::new();
    for (number, rows) in rows.chunks_mut(BAND).enumerate() {
        let top = top + number * BAND;
        let mut tail = last;
        for head in corners.clone() {
            band.mark_edge(tail, head, top..top + rows.len());
            tail = head;
        }
        band.paint(rows, color);
    }
}

/// The marks of some rows.
struct Band<const W: usize> {
    /// Where painting switches on or off: for each column, one bit a row.
    marks: [u8; W],
    spans: [Span; BAND],
}

/// What is marked in a row.
#[derive(Clone, Copy)]
struct Span {
    first: usize,
    last: usize,
    count: usize,
}

const EMPTY: Span = Span {
    first: usize::MAX,
    last: 0,
    count: 0,
};

impl<const W: usize> Band<W> {
    fn new() -> Self {
        Self {
            marks: [0; W],
            spans: [EMPTY; BAND],
        }
    }

    /// Marks where an edge crosses those of its rows that are in the band.
    fn mark_edge<T: Scalar>(&mut self, tail: [T; 2], head: [T; 2], band: Range<usize>) {
        // One order of the ends, so that the polygon on the other side computes the very same crossings.
        let (upper, lower) = if (tail[1], tail[0]) <= (head[1], head[0]) {
            (tail, head)
        } else {
            (head, tail)
        };
        let start = grid::first_from(upper[1], band.end).max(band.start);
        let end = grid::first_from(lower[1], band.end);
        let spans = self.spans.iter_mut().enumerate();
        for (number, span) in spans
            .skip(start - band.start)
            .take(end.saturating_sub(start))
        {
            let crossing = crossing(upper, lower, grid::center(band.start + number));
            let column = grid::first_from(crossing, W);
            // What is marked beyond the right margin switches nothing.
            if let Some(mark) = self.marks.get_mut(column) {
                *mark ^= 1 << number;
                span.first = span.first.min(column);
                span.last = span.last.max(column);
                span.count += 1;
            }
        }
    }

    /// Paints the rows as they are marked, and takes the marks away.
    fn paint(&mut self, rows: &mut [[u8; W]], color: u8) {
        for (number, (row, span)) in rows.iter_mut().zip(&mut self.spans).enumerate() {
            let Span { first, last, count } = core::mem::replace(span, EMPTY);
            let Some(marks) = self.marks.get_mut(first..=last) else {
                continue;
            };
            let bit = 1 << number;
            let mut paint = |span: Range<usize>| {
                if let Some(pixels) = row.get_mut(span) {
                    pixels.fill(color);
                }
            };
            if count <= 2 {
                // All there is in a convex polygon: no need to look for the marks.
                for mark in [0, last - first] {
                    if let Some(mark) = marks.get_mut(mark) {
                        *mark &= !bit;
                    }
                }
                paint(first..if count == 2 { last } else { W });
                continue;
            }
            let mut start = None;
            for (column, mark) in (first..).zip(marks) {
                if *mark & bit != 0 {
                    *mark &= !bit;
                    start = match start {
                        None => Some(column),
                        Some(start) => {
                            paint(start..column);
                            None
                        }
                    };
                }
            }
            if let Some(start) = start {
                paint(start..W);
            }
        }
    }
}

/// The abscissa at which an edge has this ordinate.
fn crossing<T: Scalar>(upper: [T; 2], lower: [T; 2], y: T) -> T {
    // Multiplied before it is divided: exact wherever the result is a number that can be written down.
    let x = upper[0] + (y - upper[1]) * (lower[0] - upper[0]) / (lower[1] - upper[1]);
    let (left, right) = if upper[0] <= lower[0] {
        (upper[0], lower[0])
    } else {
        (lower[0], upper[0])
    };
    nalgebra::RealField::max(x, left).min(right)
}
