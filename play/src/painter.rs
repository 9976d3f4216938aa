//! Where the scene of a player becomes pixels: the only place that knows how.

use crate::Player;
use mech_examples::{Picture, Scene};
use mech_runtime::{Canvas, Palette, Smooth, View};

/// Pixels that a strip is wide, and high.
const WIDE: usize = 4096;
const STRIP: usize = 24;
/// From one letter to the next, and how high one is with what hangs below, in dots.
pub(crate) const ADVANCE: usize = 6;
const LETTER: usize = 8;

/// Paints what a player shows, anti-aliased, by the runtime's own rasteriser.
#[derive(Clone, Default)]
pub struct Painter {
    strip: Box<Smooth<WIDE, STRIP>>,
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
        let mut pixels = Vec::with_capacity(width * height);
        self.rows(&scene, camera.view(), [width, height], &mut pixels);
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
        let [ink, paper] =
            [color, Palette::PAPER].map(|entry| opaque(self.strip.palette().rgb(entry)));
        let rows = self.strip.pixels().iter().take(LETTER).enumerate();
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

    /// Paints all rows.
    fn rows(
        &mut self,
        scene: &Scene,
        view: View,
        [width, height]: [usize; 2],
        pixels: &mut Vec<[u8; 4]>,
    ) {
        let shown = width.min(WIDE);
        // Pixels of the strip to the left of what is shown, and pixels of paper to the left of that.
        let left = (WIDE - shown) / 2;
        let margin = (width - shown) / 2;
        let paper = opaque(self.strip.palette().rgb(Palette::PAPER));
        for top in (0..height).step_by(STRIP) {
            self.strip
                .look_at(view_of_strip(view, [shown, height], top));
            self.strip.clear();
            scene.draw(&mut *self.strip);
            for row in self.strip.pixels().iter().take(height - top) {
                pixels.extend(std::iter::repeat_n(paper, margin));
                pixels.extend(row.iter().skip(left).take(shown));
                pixels.extend(std::iter::repeat_n(paper, width - shown - margin));
            }
        }
    }
}

/// What a strip sees whose first row is row `top` of a picture of this size.
fn view_of_strip(view: View, [width, height]: [usize; 2], top: usize) -> View {
    #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
    let [height, top, strip, odd] = [height, top, STRIP, width % 2].map(|number| number as f64);
    let down = top + strip / 2.0 - height / 2.0;
    let [x, y] = view.center();
    // The middle of a picture whose width is odd is the middle of a pixel.
    View::new(
        [x + odd / 2.0 / view.scale(), y - down / view.scale()],
        view.scale(),
    )
}

const fn opaque([red, green, blue]: [u8; 3]) -> [u8; 4] {
    [red, green, blue, 255]
}
