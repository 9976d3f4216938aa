//! The rows of a circle in which its sides are steep.

use super::Smooth;
use super::flank::{self, Flank};
use crate::Scalar;
use crate::raster::fixed;
use core::ops::Range;
use nalgebra::ComplexField;

/// How far at most, in pixels, the sides may lie outside of a straight line from border to border. The line is put outwards by so
/// much that it covers as much; where it leads through several pixels, one of them errs by a fifth of that.
const BULGE: f32 = 0.006;

/// A circle that lies between the left margin of the picture and the right one.
pub(super) struct Disc<T> {
    center: [T; 2],
    radius: f32,
    /// A twelfth of the square of its radius.
    bend: f32,
    width: f32,
}

impl<T: Scalar> Disc<T> {
    /// A circle with finite measures in a picture of some width; `None` if it lies beyond a margin, or cannot be steep.
    pub(super) fn new(center: [T; 2], radius: T, width: usize) -> Option<Self> {
        let [left, right] = [center[0] - radius, center[0] + radius];
        // A pixel of room for the bulge, and for rounding.
        let is_within = T::ONE <= left && right + T::ONE < fixed::border(width);
        let width = fixed::border::<T>(width).to_f32();
        let radius = radius.to_f32();
        let bend = radius * radius / 12.0;
        is_within.then_some(Self {
            center,
            radius,
            bend,
            width,
        })
    }

    /// Those of the rows in which its sides are steep from border to border.
    pub(super) fn steep_rows(&self, rows: Range<usize>) -> Range<usize> {
        // Half as wide as this they bulge so much.
        let half = ComplexField::cbrt(self.bend / BULGE);
        let square = (self.radius - half) * (self.radius + half);
        if square.is_nan() || square <= 0.0 {
            return rows.end..rows.end;
        }
        let reach = nalgebra::convert::<f32, T>(ComplexField::sqrt(square));
        let first = fixed::border_above(self.center[1] - reach, rows.end) + 1;
        let first = first.clamp(rows.start, rows.end);
        let end = fixed::border_above(self.center[1] + reach, rows.end);
        first..end.max(first)
    }

    /// Paints some of these rows.
    pub(super) fn paint<const W: usize, const H: usize>(
        &self,
        picture: &mut Smooth<W, H>,
        rows: Range<usize>,
        paint: [u8; 4],
    ) {
        let half = |row: usize| {
            let rise = (fixed::border::<T>(row) - self.center[1]).to_f32();
            ComplexField::sqrt((self.radius - rise) * (self.radius + rise))
        };
        let center = self.center[0].to_f32();
        let mut from = half(rows.start);
        let places = picture.pixels.iter_mut().enumerate();
        for (row, pixels) in places.skip(rows.start).take(rows.len()) {
            let to = half(row + 1);
            let mean = 0.5 * (from + to);
            let bulge = self.bend / (mean * mean * mean);
            let flank = |sign: f32| {
                let at = |half: f32| center + sign * (half + bulge);
                Flank::new(at(from), at(to), self.width)
            };
            if let [Some(left), Some(right)] = [flank(-1.0), flank(1.0)] {
                flank::fill_between(pixels, [left, right], paint);
            }
            from = to;
        }
    }
}
