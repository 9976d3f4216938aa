//! Filled circles and rings.

use super::edge;
use super::fixed;
use super::spans::{Clip, Spans};
use crate::{Real, Scalar};
use core::ops::Range;

/// Fills a circle given in pixels, but for a hole with the same centre, if there is one.
pub(super) fn fill<T: Scalar>(
    surface: &mut impl Spans,
    [x, y]: [T; 2],
    radius: T,
    hole: T,
    color: u8,
) {
    let is_finite = [x, y, radius, hole].iter().all(|&number| Real::is_finite(number));
    if !(is_finite && radius > T::ZERO && hole < radius) {
        return;
    }
    let Clip { left, top, right, bottom } = surface.clip();
    let within = |radius: T, row: usize| -> Option<Range<usize>> {
        let rise = fixed::center::<T>(row) - y;
        let square = (radius - rise) * (radius + rise);
        // Not so at a pole that rounding has carried over.
        (square >= T::ZERO).then(|| {
            let half = Real::sqrt(square);
            let from = fixed::first_from(x - half, right).max(left);
            from..fixed::first_from(x + half, right).max(from)
        })
    };
    let rows = edge::rows([y - radius, y + radius], bottom);
    for row in rows.start.max(top)..rows.end {
        let Some(outer) = within(radius, row) else {
            continue;
        };
        let inner = if hole > T::ZERO { within(hole, row) } else { None };
        match inner {
            None => surface.fill(row, outer, color),
            Some(inner) => {
                surface.fill(row, outer.start..inner.start, color);
                surface.fill(row, inner.end..outer.end, color);
            }
        }
    }
}
