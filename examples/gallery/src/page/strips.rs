//! Pictures in true colour, of any height, painted strip by strip.

use crate::Scene;
use mech_runtime::files::{self, FileError};
use mech_runtime::{Palette, Smooth, View};

/// A picture in true colour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The width in pixels.
    pub width: u16,
    /// The height in pixels.
    pub height: u16,
    /// Red, green, blue and opacity, row by row from the top.
    pub pixels: Vec<[u8; 4]>,
}

impl Picture {
    /// The width and height in pixels.
    pub(crate) fn size(&self) -> [usize; 2] {
        [self.width, self.height].map(usize::from)
    }

    /// The bytes of a PNG file of the picture.
    ///
    /// # Errors
    /// [`FileError`] if the number of pixels does not match the size, or is zero.
    pub fn png(&self) -> Result<Vec<u8>, FileError> {
        files::Picture::rgba(self.size(), &self.pixels)?.png()
    }
}

/// A strip of `W` × `H` pixels, in which pictures of any height are painted strip by strip. A wider picture has paper at both sides.
#[derive(Clone, Default)]
pub(crate) struct Strips<const W: usize, const H: usize> {
    strip: Box<Smooth<W, H>>,
}

impl<const W: usize, const H: usize> Strips<W, H> {
    /// The colours.
    pub(crate) fn palette(&self) -> &Palette {
        self.strip.palette()
    }

    /// Changes the colours.
    pub(crate) fn set_palette(&mut self, palette: Palette) {
        self.strip.set_palette(palette);
    }

    /// Paints a scene in a picture of this size.
    pub(crate) fn paint(
        &mut self,
        scene: &Scene,
        view: View,
        [width, height]: [u16; 2],
    ) -> Picture {
        let [columns, rows] = [width, height].map(usize::from);
        let shown = columns.min(W);
        // Pixels of the strip to the left of what is shown, and pixels of paper to the left of that.
        let left = (W - shown) / 2;
        let margin = (columns - shown) / 2;
        let paper = self.strip.palette().rgba(Palette::PAPER);
        let mut pixels = Vec::with_capacity(columns * rows);
        for top in (0..rows).step_by(H.max(1)) {
            self.strip.look_at(view_of_strip::<W, H>(view, [shown, rows], top));
            self.strip.clear();
            scene.draw(&mut *self.strip);
            for row in self.strip.pixels().iter().take(rows - top) {
                pixels.extend(std::iter::repeat_n(paper, margin));
                pixels.extend(row.iter().skip(left).take(shown));
                pixels.extend(std::iter::repeat_n(paper, columns - shown - margin));
            }
        }
        Picture { width, height, pixels }
    }
}

/// The view of the strip whose first row is row `top` of a picture of this size.
fn view_of_strip<const W: usize, const H: usize>(
    view: View,
    [width, height]: [usize; 2],
    top: usize,
) -> View {
    #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
    let [height, top, strip, odd] = [height, top, H, (W - width) % 2].map(|number| number as f64);
    let down = top + strip / 2.0 - height / 2.0;
    let [x, y] = view.center();
    // Where one pixel more is to the right of the picture than to its left, its middle is not the strip's.
    View::new([x + odd / 2.0 / view.scale(), y - down / view.scale()], view.scale())
}
