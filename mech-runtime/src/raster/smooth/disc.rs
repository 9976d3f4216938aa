//! A circle within a picture, for which no pixel needs a test. The rows with steep sides are filled first. The rows around the poles of a
//! large circle, which are flat, are filled pixel by pixel.

use super::Soft;
use super::flank::{self, Flank};
use super::mixing::{fill, in_255ths, mix_pixel};
use crate::Scalar;
use crate::raster::fixed;
use crate::raster::memory::{Grid, Memory};
use core::ops::Range;
use nalgebra::ComplexField;

/// The greatest distance, in pixels, of the sides from a straight line between two borders. The line is moved outwards until it covers as
/// much. Where it passes through several pixels, one of them errs by a fifth of that.
const BULGE: f32 = 0.006;

/// The same for the sides around the poles, from column to column: none leads through several pixels.
const FLAT_BULGE: f32 = 0.01;

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
        is_within.then_some(Self { center, radius, bend, width })
    }

    /// The rows in which its sides are steep from border to border.
    pub(super) fn steep_rows(&self, rows: Range<usize>) -> Range<usize> {
        // Half as wide as this they bulge so much.
        let half = ComplexField::cbrt(self.bend / BULGE);
        let square = (self.radius - half) * (self.radius + half);
        if square.is_nan() || square <= 0.0 {
            return rows.end..rows.end;
        }
        let reach = T::from_f32(ComplexField::sqrt(square));
        let first = fixed::border_above(self.center[1] - reach, rows.end) + 1;
        let first = first.max(rows.start).min(rows.end);
        let end = fixed::border_above(self.center[1] + reach, rows.end);
        first..end.max(first)
    }

    /// Paints some of these rows.
    pub(super) fn paint_steep<M: Memory>(
        &self,
        picture: &mut Soft<M>,
        rows: Range<usize>,
        paint: [u8; 4],
    ) {
        let half = |border: usize| self.half(self.rise(border));
        let center = self.center[0].to_f32();
        let mut from = half(rows.start);
        for (row, pixels) in rows.clone().zip(picture.pixels.rows_mut(rows)) {
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

    /// Whether what is not steep is flat.
    pub(super) fn has_flat_poles(&self, steep: &Range<usize>) -> bool {
        let least = ComplexField::cbrt(self.bend / FLAT_BULGE);
        let [top, bottom] = [steep.start, steep.end].map(|row| self.rise(row).abs());
        !steep.is_empty() && top.min(bottom) >= least
    }

    /// Paints some rows around its poles.
    pub(super) fn paint_poles<M: Memory>(
        &self,
        picture: &mut Soft<M>,
        rows: Range<usize>,
        paint: [u8; 4],
    ) {
        let center = self.center[0].to_f32();
        for (row, pixels) in rows.clone().zip(picture.pixels.rows_mut(rows)) {
            let [one, other] = [row, row + 1].map(|border| self.rise(border).abs());
            let (near, far) = (one.min(other), one.max(other));
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "lies within the picture"
            )]
            let columns = |half: f32| [(center - half) as usize, (center + half) as usize];
            let [start, last] = columns(self.half(near));
            let end = last + 1;
            let [left, right] =
                if far < self.radius { columns(self.half(far)) } else { [last, last] };
            // Where it is steep from border to border, all that is between is covered.
            let (left, right) = (left + 1, right.max(left + 1));
            let pixels = pixels.as_mut();
            self.paint_columns(pixels, start..left, near, paint);
            if let Some(pixels) = pixels.get_mut(left..right) {
                fill(pixels, paint);
            }
            self.paint_columns(pixels, right..end, near, paint);
        }
    }

    /// Paints some pixels of a row. The covered part of each is where the circle is farther from its horizontal diameter than the row's
    /// nearer border.
    fn paint_columns(
        &self,
        pixels: &mut [[u8; 4]],
        columns: Range<usize>,
        near: f32,
        paint: [u8; 4],
    ) {
        let start = (fixed::border::<T>(columns.start) - self.center[0]).to_f32();
        let mut run = start;
        let mut from = self.half(run);
        for pixel in pixels.get_mut(columns).unwrap_or_default() {
            run += 1.0;
            let to = self.half(run);
            let mean = 0.5 * (from + to);
            let bulge = self.bend / (mean * mean * mean);
            let share = flank::mean_around(mean + bulge - near, (to - from).abs());
            *pixel = mix_pixel(*pixel, paint, in_255ths(share));
            from = to;
        }
    }

    /// The distance of a border between rows below the centre.
    #[inline]
    fn rise(&self, border: usize) -> f32 {
        (fixed::border::<T>(border) - self.center[1]).to_f32()
    }

    /// Half of the chord that is so far from the centre.
    #[inline]
    fn half(&self, distance: f32) -> f32 {
        let square = (self.radius - distance) * (self.radius + distance);
        ComplexField::sqrt(square.max(0.0))
    }
}
