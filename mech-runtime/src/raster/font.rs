//! One small font for labels: five by seven dots, of which the lowest row is the base line.

use super::spans::{Clip, Spans};
use mech_core::font::{self, HEIGHT, glyph};

/// The distance from one letter to the next, in pixels.
pub(super) const ADVANCE: i32 = font::ADVANCE as i32;

/// Writes a text whose lower left corner is a corner between pixels.
pub(super) fn write(surface: &mut impl Spans, left: i32, bottom: i32, text: &str, color: u8) {
    let clip = surface.clip();
    let mut left = left;
    for character in text.chars() {
        letter(surface, clip, [left, bottom], glyph(character), color);
        left = left.saturating_add(ADVANCE);
    }
}

/// Writes a letter: five columns of dots, the uppermost in the lowest bit.
fn letter(
    surface: &mut impl Spans,
    clip: Clip,
    [left, bottom]: [i32; 2],
    columns: [u8; 5],
    color: u8,
) {
    for line in 0..HEIGHT {
        let row = bottom.saturating_sub(i32::from(HEIGHT - line));
        let Some(row) = within(row, clip.top, clip.bottom) else {
            continue;
        };
        for (column, dots) in (0..).zip(columns) {
            let place = within(left.saturating_add(column), clip.left, clip.right);
            if let (true, Some(place)) = (dots >> line & 1 != 0, place) {
                surface.fill(row, place..place + 1, color);
            }
        }
    }
}

fn within(pixel: i32, low: usize, high: usize) -> Option<usize> {
    let pixel = usize::try_from(pixel).ok()?;
    (low..high).contains(&pixel).then_some(pixel)
}
