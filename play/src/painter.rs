//! Where the scene of a player becomes pixels: the only place that knows how.

use crate::Player;
use mech_examples::{Picture, Scene};
use mech_runtime::{Canvas, Frame, Palette, View};

/// Samples that a strip is wide, and high.
const WIDE: usize = 4096;
const STRIP: usize = 64;
/// From one letter to the next, and how high one is with what hangs below, in dots.
pub(crate) const ADVANCE: usize = 6;
const LETTER: usize = 8;
/// How many samples a pixel may have in each direction: as many as fit, first the most.
const FINEST: [usize; 2] = [4, 2];
/// The most samples of a picture that is painted finer than its pixels, so that it keeps its pace.
const MOST: usize = 4_000_000;

/// Paints what a player shows, anti-aliased, by the runtime's own rasteriser.
#[derive(Clone, Default)]
pub struct Painter {
    strip: Box<Frame<WIDE, STRIP>>,
}

impl Painter {
    /// Paints a picture of the size that the player's camera has, in strips. What is wider than the widest strip has paper at both
    /// sides.
    #[must_use]
    pub fn paint(&mut self, player: &Player) -> Picture {
        self.strip.set_palette(if player.is_night() {
            Palette::NIGHT
        } else {
            Palette::TEXTBOOK
        });
        let camera = player.camera();
        let scene = player.scene();
        let [width, height] = camera.size().map(|side| side.min(usize::from(u16::MAX)));
        let fine = FINEST.into_iter().find(|fine| {
            let samples = width.saturating_mul(height).saturating_mul(fine * fine);
            width * fine <= WIDE && samples <= MOST
        });
        let mut pixels = Vec::with_capacity(width * height);
        match fine {
            Some(4) => self.rows::<4>(&scene, camera.view(), [width, height], &mut pixels),
            Some(_) => self.rows::<2>(&scene, camera.view(), [width, height], &mut pixels),
            None => self.rows::<1>(&scene, camera.view(), [width, height], &mut pixels),
        }
        let [width, height] = [width, height].map(|side| u16::try_from(side).unwrap_or(u16::MAX));
        Picture {
            width,
            height,
            pixels,
        }
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
        self.strip.look_at(View::default());
        self.strip.clear();
        #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
        let place = [WIDE as f64 / -2.0, STRIP as f64 / 2.0 - LETTER as f64];
        self.strip.text(place, text, color);
        let rows = self.strip.pixels().iter().take(LETTER).enumerate();
        let dots = rows.flat_map(|(row, entries)| {
            let entries = entries.iter().enumerate();
            let dots = entries.filter(|&(_, &entry)| entry != Palette::PAPER);
            dots.map(move |(column, _)| [corner[0] + column * size, corner[1] + row * size])
        });
        let palette = self.strip.palette();
        let [ink, paper] = [color, Palette::PAPER].map(|entry| palette.rgb(entry));
        let mut square = |[left, top]: [usize; 2], side: usize, rgb: [u8; 3]| {
            let width = usize::from(picture.width);
            let rows = picture.pixels.chunks_mut(width.max(1)).skip(top).take(side);
            for row in rows {
                row.iter_mut()
                    .skip(left)
                    .take(side)
                    .for_each(|pixel| *pixel = rgb);
            }
        };
        for dot in dots.clone() {
            square(dot.map(|c| c.saturating_sub(size)), 3 * size, paper);
        }
        for dot in dots {
            square(dot, size, ink);
        }
    }

    /// Paints all rows, `FINE` samples to a pixel in each direction.
    fn rows<const FINE: usize>(
        &mut self,
        scene: &Scene,
        view: View,
        [width, height]: [usize; 2],
        pixels: &mut Vec<[u8; 3]>,
    ) {
        let shown = width.min(WIDE / FINE);
        // Samples of the strip to the left of what is shown, and pixels of paper to the left of that.
        let left = (WIDE - shown * FINE) / 2;
        let margin = (width - shown) / 2;
        let paper = self.strip.palette().rgb(Palette::PAPER);
        for top in (0..height).step_by(STRIP / FINE) {
            self.strip.look_at(view_of_strip::<FINE>(view, height, top));
            self.strip.clear();
            scene.draw(&mut *self.strip);
            let (rows, _) = self.strip.pixels().as_chunks::<FINE>();
            for rows in rows.iter().take(height - top) {
                pixels.extend(std::iter::repeat_n(paper, margin));
                let palette = self.strip.palette();
                let rows = rows.each_ref().map(|row| {
                    let row = row.get(left..).unwrap_or_default();
                    row.as_chunks::<FINE>().0
                });
                let blocks = (0..shown).map(|column| {
                    rows.map(|row| row.get(column).copied().unwrap_or([Palette::PAPER; FINE]))
                });
                pixels.extend(blocks.map(|block| mean(palette, block)));
                pixels.extend(std::iter::repeat_n(paper, width - shown - margin));
            }
        }
    }
}

/// What a strip sees whose first row is row `top` of a picture so many pixels high, with `FINE` samples to a pixel.
fn view_of_strip<const FINE: usize>(view: View, height: usize, top: usize) -> View {
    #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
    let [height, top, strip, fine] = [height, top, STRIP, FINE].map(|number| number as f64);
    let down = top + strip / fine / 2.0 - height / 2.0;
    let [x, y] = view.center();
    View::new([x, y - down / view.scale()], view.scale() * fine)
}

/// The mean of a block of samples.
fn mean<const FINE: usize>(palette: &Palette, block: [[u8; FINE]; FINE]) -> [u8; 3] {
    let samples = block.as_flattened();
    let first = samples.first().copied().unwrap_or(Palette::PAPER);
    if block == [[first; FINE]; FINE] {
        return palette.rgb(first);
    }
    let mut sums = [0_u16; 3];
    for &sample in samples {
        for (sum, channel) in sums.iter_mut().zip(palette.rgb(sample)) {
            *sum += u16::from(channel);
        }
    }
    let samples = u16::try_from(FINE * FINE).unwrap_or(1);
    sums.map(|sum| u8::try_from((sum + samples / 2) / samples).unwrap_or(u8::MAX))
}
