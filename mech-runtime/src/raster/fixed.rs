//! Positions in pixels as whole numbers of 2⁻⁴⁰ of a pixel: from here on, all is exact. The centre of pixel `n` is at `n + 1/2`.

use crate::{Real, Scalar};

/// Bits behind the point.
pub(super) const FRACTION: u32 = 40;
/// Half a pixel.
pub(super) const HALF: i64 = 1 << (FRACTION - 1);
/// Positions beyond this many pixels are replaced, because no picture is larger.
pub(super) const FAR: i32 = 1 << 21;
/// The most pixels a picture has in one direction.
pub(super) const MOST: usize = 1 << 21;

/// The first of the pixels `0..count` whose centre is at `position` or beyond; `count` if there is none.
#[inline]
pub(super) fn first_from<T: Scalar>(position: T, count: usize) -> usize {
    let right = Scalar::to_fixed(position).saturating_add(HALF - 1);
    within(pixel(right), 0, count)
}

/// The pixel in which a position lies.
#[inline]
pub(super) const fn pixel(position: i64) -> i64 {
    position >> FRACTION
}

/// A pixel's number, or the bound next to it.
#[inline]
pub(super) fn within(pixel: i64, low: usize, high: usize) -> usize {
    #[expect(
        clippy::cast_possible_wrap,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "lies between two sizes of pictures"
    )]
    let within = pixel.max(low as i64).min(high as i64) as usize;
    within
}

/// The centre of a pixel. A small integer in between spares machines without `f64`.
#[inline]
pub(super) fn center<T: Scalar>(index: usize) -> T {
    let index = i32::try_from(index).unwrap_or(i32::MAX);
    <T as Real>::from_i32(index) + <T as Real>::HALF
}

/// The border before a pixel.
#[inline]
pub(super) fn border<T: Scalar>(index: usize) -> T {
    <T as Real>::from_i32(i32::try_from(index).unwrap_or(i32::MAX))
}

/// The last border of a picture's rows that is not below an ordinate.
#[inline]
pub(super) fn border_above<T: Scalar>(ordinate: T, height: usize) -> usize {
    within(pixel(Scalar::to_fixed(ordinate)), 0, height)
}

/// The rows of a picture that lie at least in part between two ordinates.
pub(super) fn rows_touching<T: Scalar>(
    [high, low]: [T; 2],
    height: usize,
) -> core::ops::Range<usize> {
    let first = border_above(high, height);
    let end = pixel(Scalar::to_fixed(low).saturating_add(2 * HALF - 1));
    first..within(end, first, height)
}

/// The pixel border nearest to a position, or a far one for a far position.
pub(super) fn nearest<T: Scalar>(position: T) -> i32 {
    let pixel = pixel(Scalar::to_fixed(position).saturating_add(HALF));
    i32::try_from(pixel).unwrap_or(FAR)
}
