//! Where the scene of a player becomes pixels: the only place that knows how.

use crate::Player;
use mech_gallery::{Picture, Strips};
use mech_runtime::{Canvas, Palette};

/// Pixels that a strip is wide, and high.
const WIDE: usize = 4096;
const STRIP: usize = 24;
/// From one letter to the next, and how high one is with what hangs below, in dots.
pub(crate) const ADVANCE: usize = 6;
const LETTER: usize = 8;

/// Paints what a player shows, anti-aliased, by the runtime's own rasteriser.
#[derive(Clone, Default)]
pub struct Painter {
    strips: Strips<WIDE, STRIP>,
}

impl Painter {
    /// Paints a picture of the size that the player's camera has, in strips. What is wider than the widest strip has paper at both
    /// sides.
    #[must_use]
    pub fn paint(&mut self, player: &Player) -> Picture {
        self.strips.set_palette(if player.is_night() {
            Palette::NIGHT
        } else {
            Palette::TEXTBOOK
        });
        let camera = player.camera();
        let narrow = |side: usize| u16::try_from(side).unwrap_or(u16::MAX);
        let size = camera.size().map(narrow);
        self.strips.paint(&player.scene(), camera.view(), size)
    }

    /// Writes a line of text into a picture, with its upper left corner at a pixel, each dot of a letter a square of `size` pixels; a
    /// seam of paper parts it from what is behind it.
    pub fn write(
        &mut self,
        picture: &mut Picture,
        corner: [usize; 2],
        text: &str,
        size: usize,
        color: u8,
    ) {
        let strip = self.strips.clear();
        #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
        let place = [WIDE as f64 / -2.0, STRIP as f64 / 2.0 - LETTER as f64];
        strip.text(place, text, color);
        let [ink, paper] = [color, Palette::PAPER].map(|entry| strip.palette().rgba(entry));
        let rows = strip.pixels().iter().take(LETTER).enumerate();
        let dots = rows.flat_map(|(row, pixels)| {
            let pixels = pixels.iter().enumerate();
            let dots = pixels.filter(|&(_, &pixel)| pixel != paper);
            dots.map(move |(column, _)| [corner[0] + column * size, corner[1] + row * size])
        });
        let mut square = |[left, top]: [usize; 2], side: usize, color: [u8; 4]| {
            let width = usize::from(picture.width);
            let rows = picture.pixels.chunks_mut(width.max(1)).skip(top).take(side);
            for row in rows {
                row.iter_mut()
                    .skip(left)
                    .take(side)
                    .for_each(|pixel| *pixel = color);
            }
        };
        for dot in dots.clone() {
            square(dot.map(|c| c.saturating_sub(size)), 3 * size, paper);
        }
        for dot in dots {
            square(dot, size, ink);
        }
    }
}
