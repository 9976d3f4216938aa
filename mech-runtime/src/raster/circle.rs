//! Filled circles.

use super::grid;
use crate::Scalar;

/// Fills a circle given in pixels.
pub(super) fn fill<T: Scalar, const W: usize>(
    rows: &mut [[u8; W]],
    [x, y]: [T; 2],
    radius: T,
    color: u8,
) {
    if !(x.is_finite() && y.is_finite() && radius.is_finite() && radius > T::zero()) {
        return;
    }
    let first = grid::first_from(y - radius, rows.len());
    let end = grid::first_from(y + radius, rows.len());
    for (index, row) in rows.iter_mut().enumerate().take(end).skip(first) {
        let rise = grid::center::<T>(index) - y;
        let square = (radius - rise) * (radius + rise);
        if square < T::zero() {
            continue; // a pole that rounding has carried over
        }
        let half = nalgebra::ComplexField::sqrt(square);
        let span = grid::first_from(x - half, W)..grid::first_from(x + half, W);
        if let Some(pixels) = row.get_mut(span) {
            pixels.fill(color);
        }
    }
}
