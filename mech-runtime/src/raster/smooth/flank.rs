//! The pixels of a row that one side of a shape covers in part.

use super::mixing::{fill, in_255ths, mix_pixel};
use crate::Real;

/// The least run, in pixels per row. A steeper side covers as much as one with this run.
const LEAST_RUN: f32 = 1.0 / 512.0;

/// The part of a side that crosses a row from its upper border to its lower one, within the picture.
#[derive(Clone, Copy)]
pub(super) struct Flank {
    left: f32,
    right: f32,
    /// The pixels that it may divide. They are two at least, so that there is less to be decided.
    first: u32,
    end: u32,
}

impl Flank {
    /// Between two abscissas in a picture of some width; `None` if not both are within it.
    #[inline]
    pub(super) fn new(from: f32, to: f32, width: f32) -> Option<Self> {
        let (left, right) = if from <= to { (from, to) } else { (to, from) };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "lies within the picture"
        )]
        (left >= 0.0 && right < width).then(|| Self {
            left,
            right,
            first: left as u32,
            end: (right as u32 + 1).max(left as u32 + 2),
        })
    }

    /// Gives its pixels another colour, each by a share that follows from how much of it is on the right.
    #[inline]
    fn paint(self, pixels: &mut [[u8; 4]], share: impl Fn(f32) -> f32, paint: [u8; 4]) {
        let drawn = self.right - self.left;
        let run = Real::max(drawn, LEAST_RUN);
        let density = 1.0 / run;
        #[expect(clippy::cast_precision_loss, reason = "no picture is 2²⁴ pixels wide")]
        let mut far = 1.0 + self.first as f32 - self.left + 0.5 * (run - drawn);
        let mut covered = |pixel: &mut [u8; 4]| {
            let beyond = (sum_to(far) - sum_to(far - run)) * density;
            *pixel = mix_pixel(*pixel, paint, in_255ths(share(beyond)));
            far += 1.0;
        };
        if let [one, other, more @ ..] = pixels {
            covered(one);
            covered(other);
            more.iter_mut().for_each(covered);
        } else {
            pixels.iter_mut().for_each(covered);
        }
    }
}

/// The mean of a range of numbers around a middle, each clamped between zero and one.
#[inline]
pub(super) fn mean_around(middle: f32, run: f32) -> f32 {
    let run = Real::max(run, LEAST_RUN);
    let (low, high) = (middle - 0.5 * run, middle + 0.5 * run);
    (sum_to(high) - sum_to(low)) / run
}

/// The integral, from zero to `end`, of numbers that are clamped between zero and one.
#[inline]
fn sum_to(end: f32) -> f32 {
    let part = if end < 1.0 { Real::max(end, 0.0) } else { 1.0 };
    part * (end - 0.5 * part)
}

/// Gives what is between two flanks another colour, each pixel as far as it is covered; `false` if they share a pixel.
#[inline]
pub(super) fn fill_between<R: AsMut<[[u8; 4]]> + ?Sized>(
    pixels: &mut R,
    [one, other]: [Flank; 2],
    paint: [u8; 4],
) -> bool {
    let (left, right) = if one.first <= other.first { (one, other) } else { (other, one) };
    if left.end > right.first {
        return false;
    }
    let [start, whole, border] = [left.first, left.end, right.first].map(|pixel| pixel as usize);
    let pixels = pixels.as_mut();
    let end = pixels.len().min(right.end as usize);
    if let Some(pixels) = pixels.get_mut(start..whole) {
        left.paint(pixels, |beyond| beyond, paint);
    }
    if let Some(pixels) = pixels.get_mut(whole..border) {
        fill(pixels, paint);
    }
    if let Some(pixels) = pixels.get_mut(border..end) {
        right.paint(pixels, |beyond| 1.0 - beyond, paint);
    }
    true
}
