//! Where scenes become pictures: painted large by the runtime's rasteriser, and averaged down.

use crate::{Film, Picture, Scene};
use mech_runtime::files::Sheet;
use mech_runtime::{Frame, Palette, View};

/// The longer side of a picture, and the least of the shorter one.
const LONG: u16 = 640;
const SHORT: u16 = 240;
/// Paper left free around what is seen.
const MARGIN: u16 = 24;
/// Samples a pixel in each direction.
const FINE: usize = 4;
/// A picture is painted in strips, so that a small frame will do: this many samples high.
const STRIP: usize = 16 * FINE;

/// Paints the scenes of one film, all in the same view.
#[derive(Clone)]
pub struct Easel {
    strip: Box<Frame<{ LONG as usize * FINE }, STRIP>>,
    /// Of the whole picture, in samples.
    view: View,
    width: u16,
    height: u16,
}

impl Easel {
    /// Chooses the size and the view such that everything in the film is seen, and as large as possible; `None` if there
    /// is nothing to be seen.
    #[must_use]
    pub fn for_film(film: &Film) -> Option<Self> {
        let [low, high] = film.bounds()?;
        let extent = [high[0] - low[0], high[1] - low[1]];
        let longer = extent[0].max(extent[1]);
        let [width, height] = extent.map(|extent| {
            // Of a point, NaN: a number for which `max` has no ear.
            let inner = f64::from(LONG - 2 * MARGIN) * (extent / longer);
            let outer = (inner.ceil() + f64::from(2 * MARGIN)).max(SHORT.into());
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "in SHORT..=LONG"
            )]
            let even = outer as u16 & !1;
            even
        });
        let samples = |pixels: u16| usize::from(pixels) * FINE;
        let margin = samples(MARGIN);
        #[expect(clippy::cast_precision_loss, reason = "a hundred")]
        let view = View::fit(low, high, samples(width), samples(height), margin as f64);
        Some(Self {
            strip: Box::default(),
            view,
            width,
            height,
        })
    }

    /// How many pixels of a picture are a scene unit.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "four")]
    pub const fn scale(&self) -> f64 {
        self.view.scale() / FINE as f64
    }

    /// A sheet that looks like its pictures.
    #[must_use]
    pub fn sheet(&self) -> Sheet {
        let view = View::new(self.view.center(), self.scale());
        Sheet::new(self.width.into(), self.height.into())
            .look_at(view)
            .palette(self.strip.palette().clone())
    }

    /// Paints with other colours.
    pub fn set_palette(&mut self, palette: Palette) {
        self.strip.set_palette(palette);
    }

    /// Paints a scene.
    #[must_use]
    pub fn paint(&mut self, scene: &Scene) -> Picture {
        let [width, height] = [self.width, self.height].map(usize::from);
        let mut pixels = Vec::with_capacity(width * height);
        for top in (0..height * FINE).step_by(STRIP) {
            self.strip.look_at(self.view_of_strip(top));
            self.strip.clear();
            scene.draw(&mut *self.strip);
            let (pixel_rows, _) = self.strip.pixels().as_chunks::<FINE>();
            for rows in pixel_rows {
                let [a, b, c, d] = rows.each_ref().map(|row| row.as_chunks::<FINE>().0);
                let blocks = a.iter().zip(b).zip(c.iter().zip(d));
                let blocks = blocks.map(|((a, b), (c, d))| [*a, *b, *c, *d]);
                pixels.extend(
                    blocks
                        .take(width)
                        .map(|block| mean(self.strip.palette(), block)),
                );
            }
        }
        pixels.truncate(width * height);
        Picture {
            width: self.width,
            height: self.height,
            pixels,
        }
    }

    /// What the strip sees whose first row is row `top` of the picture, and whose first column is the picture's.
    fn view_of_strip(&self, top: usize) -> View {
        let [x, y] = self.view.center();
        let scale = self.view.scale();
        #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
        let down = (top + STRIP / 2) as f64 - f64::from(self.height) / 2.0 * FINE as f64;
        #[expect(clippy::cast_precision_loss, reason = "four")]
        let right = f64::from(LONG - self.width) / 2.0 * FINE as f64;
        View::new([x + right / scale, y - down / scale], scale)
    }
}

/// The mean of a block of samples.
fn mean(palette: &Palette, block: [[u8; FINE]; FINE]) -> [u8; 4] {
    let [[first, ..], ..] = block;
    let opaque = |[red, green, blue]: [u8; 3]| [red, green, blue, u8::MAX];
    if block == [[first; FINE]; FINE] {
        return opaque(palette.rgb(first));
    }
    let mut sums = [0_u16; 3];
    for &sample in block.as_flattened() {
        for (sum, channel) in sums.iter_mut().zip(palette.rgb(sample)) {
            *sum += u16::from(channel);
        }
    }
    let samples = 16;
    opaque(sums.map(|sum| u8::try_from((sum + samples / 2) / samples).unwrap_or(u8::MAX)))
}
