//! What one side of a shape leaves of the pixels in a row.

use super::mixing::{in_255ths, mixed};

/// The part of a side that crosses a row from its upper border to its lower one, within the picture.
#[derive(Clone, Copy)]
pub(super) struct Flank {
    left: f32,
    right: f32,
    /// The pixels in which these lie.
    first: u32,
    last: u32,
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
            last: right as u32,
        })
    }

    /// Gives its pixels another colour, each by a share that follows from how much of it is on the right.
    #[inline]
    fn paint(self, pixels: &mut [[u8; 4]], share: impl Fn(f32) -> f32, paint: [u8; 4]) {
        #[expect(clippy::cast_precision_loss, reason = "no picture is 2²⁴ pixels wide")]
        let (x, y) = (self.left - self.first as f32, self.right - self.last as f32);
        let mix = |pixel: &mut [u8; 4], beyond: f32| {
            *pixel = mixed(*pixel, paint, in_255ths(share(beyond)));
        };
        // It grows as the square in the first and the last pixel, evenly between.
        match pixels {
            [] => {}
            [pixel] => mix(pixel, 1.0 - 0.5 * (x + y)),
            [first, between @ .., last] => {
                let slope = 1.0 / (self.right - self.left);
                mix(first, 0.5 * slope * (1.0 - x) * (1.0 - x));
                let mut beyond = slope * (1.5 - x);
                for pixel in between {
                    mix(pixel, beyond);
                    beyond += slope;
                }
                mix(last, 1.0 - 0.5 * slope * y * y);
            }
        }
    }
}

/// Gives what is between two flanks another colour, each pixel as far as it is covered; `false` if they share a pixel.
#[inline]
pub(super) fn fill_between<const W: usize>(
    pixels: &mut [[u8; 4]; W],
    [one, other]: [Flank; 2],
    paint: [u8; 4],
) -> bool {
    let (left, right) = if one.first <= other.first {
        (one, other)
    } else {
        (other, one)
    };
    if left.last >= right.first {
        return false;
    }
    let [start, whole, border, end] = [left.first, left.last + 1, right.first, right.last + 1];
    if let Some(pixels) = pixels.get_mut(start as usize..whole as usize) {
        left.paint(pixels, |beyond| beyond, paint);
    }
    if let Some(pixels) = pixels.get_mut(whole as usize..border as usize) {
        pixels.fill(paint);
    }
    if let Some(pixels) = pixels.get_mut(border as usize..end as usize) {
        right.paint(pixels, |beyond| 1.0 - beyond, paint);
    }
    true
}
