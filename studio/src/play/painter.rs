//! Where what a player shows becomes pixels.

use super::Player;
use crate::failure::Failure;
use mech_runtime::{Canvas, HeapSmooth, Outline, Palette, Pose, View};

/// From one letter to the next, and how high one is with what hangs below, in dots.
pub(super) const ADVANCE: usize = 6;
const LETTER: usize = 8;

/// Paints what a player shows, anti-aliased, by the runtime's own rasteriser.
#[derive(Clone)]
pub struct Painter {
    picture: HeapSmooth,
}

impl Painter {
    /// A painter with an empty picture of this size.
    ///
    /// # Errors
    /// If there is no memory for it.
    pub fn new(size: [usize; 2]) -> Result<Self, Failure> {
        let [width, height] = size;
        let picture = HeapSmooth::new(width, height)?;
        Ok(Self { picture })
    }

    /// Paints a picture of the size that the player's camera has.
    ///
    /// # Errors
    /// If there is no memory for it.
    pub fn paint(&mut self, player: &Player) -> Result<&HeapSmooth, Failure> {
        let camera = player.camera();
        if [self.picture.width(), self.picture.height()] != camera.size() {
            *self = Self::new(camera.size())?;
        }
        self.picture.set_palette(if player.is_night() {
            Palette::NIGHT
        } else {
            Palette::TEXTBOOK
        });
        self.picture.look_at(camera.view());
        self.picture.clear();
        player.draw(&mut self.picture);
        Ok(&self.picture)
    }

    /// The present picture.
    #[must_use]
    pub const fn picture(&self) -> &HeapSmooth {
        &self.picture
    }

    /// Writes a line of text into the picture, with its upper left corner at a pixel, each dot of a letter a square of `size` pixels; a
    /// seam of paper parts it from what is behind it.
    pub(super) fn write(
        &mut self,
        [left, top]: [usize; 2],
        text: &str,
        size: usize,
        color: u8,
    ) -> Result<(), Failure> {
        let [width, height] = [self.picture.width(), self.picture.height()].map(count);
        // A pixel is a scene unit, and the upper left corner is the origin.
        self.picture.look_at(View::new([width / 2.0, -height / 2.0], 1.0));
        let [left, top, size] = [left, top, size].map(count);
        let dots = dots(text)?;
        for (seam, color) in [(size, Palette::PAPER), (0.0, color)] {
            for [column, row] in &dots {
                let [x, y] = [left + column * size - seam, -(top + row * size - seam)];
                let side = size + 2.0 * seam;
                let square = [[x, y], [x + side, y], [x + side, y - side], [x, y - side]];
                let square = Outline::Polygon(&square);
                self.picture.fill(square, Pose::identity(), color);
            }
        }
        Ok(())
    }
}

/// The columns and rows of the dots of a text.
fn dots(text: &str) -> Result<Vec<[f64; 2]>, Failure> {
    let width = ADVANCE * text.chars().count();
    let mut letters = HeapSmooth::new(width, LETTER)?;
    let corner = [count(width) / -2.0, count(LETTER) / -2.0];
    letters.text(corner, text, Palette::INK);
    let paper = letters.palette().rgba(Palette::PAPER);
    let rows = letters.pixels().chunks(width.max(1)).enumerate();
    let dots = rows.flat_map(|(row, pixels)| {
        let pixels = pixels.iter().enumerate();
        let dots = pixels.filter(|&(_, &pixel)| pixel != paper);
        dots.map(move |(column, _)| [column, row].map(count))
    });
    Ok(dots.collect())
}

#[expect(clippy::cast_precision_loss, reason = "a few thousand")]
fn count(number: usize) -> f64 {
    number as f64
}
