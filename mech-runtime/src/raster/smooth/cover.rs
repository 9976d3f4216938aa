//! How much of each pixel in a row is covered.

use super::runs::Runs;
use crate::raster::polygon::Rule;
use core::ops::Range;

/// What the sides of a shape add in a row: the share of a pixel that is covered is the sum of all that is added up to it.
#[derive(Clone)]
pub(super) struct Cover<const W: usize> {
    gains: [f32; W],
    /// Where something is added.
    runs: Runs,
}

impl<const W: usize> Cover<W> {
    pub(super) const fn new() -> Self {
        Self {
            gains: [0.0; W],
            runs: Runs::new(),
        }
    }

    /// Adds the part of a side that lies in the row, from one abscissa to another; everything to its right is covered by `gain`, its
    /// height with the sign of its direction.
    #[inline]
    pub(super) fn add(&mut self, from: f32, to: f32, gain: f32) {
        let (left, right) = if from <= to { (from, to) } else { (to, from) };
        #[expect(clippy::cast_precision_loss, reason = "no picture is 2²⁴ pixels wide")]
        let width = W as f32;
        if left >= 0.0 && right < width {
            self.add_inside(left, right, gain);
        } else if right <= 0.0 {
            self.add_inside(0.0, 0.0, gain);
        } else if left < width && left <= right {
            // In parts; what is beyond the right margin covers nothing that is seen.
            let share = gain / (right - left);
            if left < 0.0 {
                self.add_inside(0.0, 0.0, -left * share);
            }
            let (from, to) = (left.max(0.0), right.min(width));
            self.add_inside(from, to, (to - from) * share);
        }
    }

    fn add_inside(&mut self, left: f32, right: f32, gain: f32) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "lies within the picture"
        )]
        let [first, last] = [left as u32, right as u32];
        #[expect(clippy::cast_precision_loss, reason = "no picture is 2²⁴ pixels wide")]
        let (x, y) = (left - first as f32, right - last as f32);
        self.runs.add(first, last + 1);
        let Some(gains) = self.gains.get_mut(first as usize..) else {
            return;
        };
        if first == last {
            let beyond = gain * 0.5 * (x + y);
            if let [here, next, ..] = gains {
                *here += gain - beyond;
                *next += beyond;
            } else if let [here] = gains {
                *here += gain - beyond;
            }
            return;
        }
        // The share that is covered grows along the side as its square in the first and the last pixel, evenly between.
        let slope = gain / (right - left);
        let mut covered = 0.5 * slope * (1.0 - x) * (1.0 - x);
        let mut pixels = gains.iter_mut().take((last - first) as usize + 2);
        if let Some(pixel) = pixels.next() {
            *pixel += covered;
        }
        let mut next = slope * (1.5 - x);
        for pixel in pixels.by_ref().take((last - first) as usize - 1) {
            *pixel += next - covered;
            covered = next;
            next += slope;
        }
        // In the last pixel all but what is beyond the side there; in the one after it, that too.
        let beyond = 0.5 * slope * y * y;
        if let Some(pixel) = pixels.next() {
            *pixel += gain - beyond - covered;
        }
        if let Some(pixel) = pixels.next() {
            *pixel += beyond;
        }
    }

    /// Tells what share of which pixels is covered, from left to right, and forgets it.
    #[inline]
    pub(super) fn settle(&mut self, rule: Rule, mut tell: impl FnMut(Range<usize>, u32)) {
        let mut sum = 0.0;
        let mut end = 0;
        for (first, last) in self.runs.take() {
            let share = share(rule, sum);
            if share > 0 && end < first {
                tell(end..first, share);
            }
            end = (last + 1).min(W);
            let gains = self.gains.get_mut(first..end).unwrap_or_default();
            for (column, gain) in (first..).zip(gains) {
                sum += core::mem::take(gain);
                let share = self::share(rule, sum);
                if share > 0 {
                    tell(column..column + 1, share);
                }
            }
        }
        let share = share(rule, sum);
        if share > 0 && end < W {
            tell(end..W, share);
        }
    }
}

/// The share of a pixel that is covered, in 255ths, if this is how often it is surrounded.
#[inline]
fn share(rule: Rule, winding: f32) -> u32 {
    let winding = winding.abs();
    let part = match rule {
        Rule::NonZero => winding.min(1.0),
        Rule::EvenOdd if winding <= 1.0 => winding,
        Rule::EvenOdd => {
            #[expect(
                clippy::cast_possible_truncation,
                reason = "the whole part is what is wanted"
            )]
            let pairs = (0.5 * winding) as i32;
            #[expect(clippy::cast_precision_loss, reason = "nothing is surrounded so often")]
            let rest = winding - 2.0 * pairs as f32;
            rest.min(2.0 - rest)
        }
    };
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "lies in 0..=255"
    )]
    let share = (part * 255.0 + 0.5) as u32;
    share
}

/// Gives a share of some pixels, in 255ths, another colour.
#[inline]
pub(super) fn mix(pixels: &mut [[u8; 4]], share: u32, paint: [u8; 4]) {
    if share >= 255 {
        pixels.fill(paint);
        return;
    }
    for pixel in pixels {
        for (channel, paint) in pixel.iter_mut().zip(paint) {
            let sum = u32::from(*channel) * (255 - share) + u32::from(paint) * share;
            // A division by 255, rounded.
            let sum = sum + 128;
            #[expect(clippy::cast_possible_truncation, reason = "a mean of two bytes")]
            let mean = ((sum + (sum >> 8)) >> 8) as u8;
            *channel = mean;
        }
    }
}
