//! Short decimal numbers.

use core::fmt;
use std::format;

/// A number with at most so many decimals, without zeros at the end.
#[derive(Clone, Copy)]
pub(super) struct Number(pub(super) f64, pub(super) usize);

/// Decimals of lengths in pixels. Sums of several such numbers are exact to a thousandth of a pixel.
pub(super) const DECIMALS: usize = 4;

/// Beyond so many pixels nothing is drawn, because viewers compute in single precision.
const FARTHEST: f64 = 1e30;

/// Whether a number of pixels can be drawn.
pub(super) fn is_drawable(value: f64) -> bool {
    value.abs() <= FARTHEST
}

/// A number of pixels.
pub(super) const fn pixels(value: f64) -> Number {
    Number(value, DECIMALS)
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value, decimals) = *self;
        let text = format!("{value:.decimals$}");
        let text = match text.split_once('.') {
            Some(_) => text.trim_end_matches('0').trim_end_matches('.'),
            None => &text,
        };
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

/// Returns the number of further decimals of a number that is multiplied by lengths up to `extent` pixels.
pub(super) fn digits(extent: f64) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 309")]
    let digits = extent.max(1.0).log10().ceil() as usize;
    digits
}

#[expect(clippy::cast_precision_loss, reason = "a few thousand")]
pub(super) fn share(index: usize, count: usize) -> f64 {
    index as f64 / count.max(1) as f64
}
