//! The coverage of each pixel in a row.

use super::mixing::{in_255ths, mix, mix_pixel};
use super::runs::Runs;
use crate::raster::crossings::Rule;

/// The gains that the sides of a shape add in a row. The covered share of a pixel is the sum of all gains up to it.
#[derive(Clone)]
pub(super) struct Cover<G> {
    /// A number for each pixel.
    gains: G,
    /// The pixels with gains.
    runs: Runs,
}

impl<G> Cover<G> {
    /// The cover of an empty row, with a zero for each pixel.
    pub(super) const fn new(gains: G) -> Self {
        Self { gains, runs: Runs::new() }
    }
}

impl<G: AsRef<[f32]> + AsMut<[f32]>> Cover<G> {
    #[inline]
    fn width(&self) -> f32 {
        #[expect(clippy::cast_precision_loss, reason = "no picture is 2²⁴ pixels wide")]
        let width = self.gains.as_ref().len() as f32;
        width
    }

    /// Adds the part of a side that lies in the row, from one abscissa to another. Everything to its right is covered by `gain`, its height with
    /// the sign of its direction. It is seen where the row is [touched](Self::touch).
    #[inline]
    pub(super) fn add(&mut self, from: f32, to: f32, gain: f32) {
        let (left, right) = if from <= to { (from, to) } else { (to, from) };
        let width = self.width();
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

    #[inline]
    fn add_inside(&mut self, left: f32, right: f32, gain: f32) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "lies within the picture"
        )]
        let [first, last] = [left as u32, right as u32];
        #[expect(clippy::cast_precision_loss, reason = "no picture is 2²⁴ pixels wide")]
        let (x, y) = (left - first as f32, right - last as f32);
        let Some(gains) = self.gains.as_mut().get_mut(first as usize..) else {
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
        } else {
            across(gains, [x, y], (right - left, last - first), gain);
        }
    }

    /// Notes that something was added between two abscissas.
    #[inline]
    pub(super) fn touch(&mut self, from: f32, to: f32) {
        let width = self.width();
        let (left, right) = if from <= to { (from, to) } else { (to, from) };
        if left < width {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "what is beyond the left margin is on it"
            )]
            self.runs.add(left as u32, right.min(width) as u32 + 1);
        }
    }

    /// Gives the pixels of the row another colour, each as far as it is covered, and forgets what covers them.
    #[inline]
    pub(super) fn settle<R: AsMut<[[u8; 4]]> + ?Sized>(
        &mut self,
        rule: Rule,
        pixels: &mut R,
        paint: [u8; 4],
    ) {
        let (pixels, gains) = (pixels.as_mut(), self.gains.as_mut());
        let mut sum = 0.0;
        let mut end = 0;
        for (first, last) in self.runs.take() {
            if end < first {
                mix(pixels.get_mut(end..first).unwrap_or_default(), share(rule, sum), paint);
            }
            end = (last + 1).min(gains.len());
            let gains = gains.get_mut(first..end).unwrap_or_default();
            let pixels = pixels.get_mut(first..end).unwrap_or_default();
            for (pixel, gain) in pixels.iter_mut().zip(gains) {
                sum += core::mem::take(gain);
                match share(rule, sum) {
                    0 => {}
                    255 => *pixel = paint,
                    share => *pixel = mix_pixel(*pixel, paint, share),
                }
            }
        }
        mix(pixels.get_mut(end..).unwrap_or_default(), share(rule, sum), paint);
    }
}

/// Adds a side that leads through several pixels: from a place in the first to one in the last, and how far these are apart.
#[inline]
fn across(gains: &mut [f32], [x, y]: [f32; 2], (run, pixels): (f32, u32), gain: f32) {
    // The share that is covered grows along the side as its square in the first and the last pixel, evenly between.
    let slope = gain / run;
    let mut covered = 0.5 * slope * (1.0 - x) * (1.0 - x);
    let more = pixels as usize;
    let mut pixels = gains.iter_mut().take(more + 2);
    if let Some(pixel) = pixels.next() {
        *pixel += covered;
    }
    let mut next = slope * (1.5 - x);
    for pixel in pixels.by_ref().take(more - 1) {
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

/// The share of a pixel that is covered, in 255ths, if this is how often it is surrounded.
#[inline]
fn share(rule: Rule, winding: f32) -> u32 {
    let winding = winding.abs();
    let part = if winding <= 1.0 { winding } else { more_than_once(rule, winding) };
    in_255ths(part)
}

#[cold]
fn more_than_once(rule: Rule, winding: f32) -> f32 {
    match rule {
        Rule::NonZero => 1.0,
        Rule::EvenOdd => {
            #[expect(clippy::cast_possible_truncation, reason = "the whole part is what is wanted")]
            let pairs = (0.5 * winding) as i32;
            #[expect(clippy::cast_precision_loss, reason = "nothing is surrounded so often")]
            let remainder = winding - 2.0 * pairs as f32;
            remainder.min(2.0 - remainder)
        }
    }
}
