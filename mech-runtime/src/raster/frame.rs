//! A picture in memory.

use super::spans::{Clip, Spans};
use super::{Canvas, Palette, View, paint};
use crate::{Outline, Pose, Real, Scalar};
use core::fmt;
use core::ops::Range;

/// A picture `W` pixels wide and `H` high: a byte a pixel, a palette, and a view of the scene.
///
/// Nothing is allocated, and [`new`](Self::new) can initialise a static:
///
/// ```
/// use std::sync::Mutex;
/// use mech_runtime::Frame;
///
/// static SCREEN: Mutex<Frame<320, 240>> = Mutex::new(Frame::new());
/// ```
///
/// A picture too large for memory can be painted in strips, each in the same small frame with a
/// [`View`] that looks at another part of the scene.
#[derive(Clone, PartialEq)]
pub struct Frame<const W: usize, const H: usize> {
    pixels: [[u8; W]; H],
    palette: Palette,
    view: View,
}

impl<const W: usize, const H: usize> Frame<W, H> {
    /// An empty picture, with the [textbook](Palette::TEXTBOOK) palette, that looks at the scene's origin with one pixel
    /// a unit.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            pixels: [[Palette::PAPER; W]; H],
            palette: Palette::TEXTBOOK,
            view: View::new([0.0, 0.0], 1.0),
        }
    }

    /// Paints everything in colour 0.
    pub fn clear(&mut self) {
        for row in &mut self.pixels {
            row.fill(Palette::PAPER);
        }
    }

    /// The pixels, each an entry of the palette, row by row from the top.
    #[must_use]
    pub const fn pixels(&self) -> &[[u8; W]; H] {
        &self.pixels
    }

    /// The pixels, to be painted.
    #[cfg(feature = "embedded-graphics")]
    pub(super) const fn pixels_mut(&mut self) -> &mut [[u8; W]; H] {
        &mut self.pixels
    }

    /// A pixel's entry in the palette; `x` counts from the left, `y` from the top.
    #[must_use]
    pub fn pixel(&self, x: usize, y: usize) -> Option<u8> {
        self.pixels.get(y)?.get(x).copied()
    }

    /// A pixel's red, green and blue; `x` counts from the left, `y` from the top.
    #[must_use]
    pub fn rgb(&self, x: usize, y: usize) -> Option<[u8; 3]> {
        Some(self.palette.rgb(self.pixel(x, y)?))
    }

    /// The colours.
    #[must_use]
    pub const fn palette(&self) -> &Palette {
        &self.palette
    }

    /// Changes the colours, also of what is already painted.
    pub const fn set_palette(&mut self, palette: Palette) {
        self.palette = palette;
    }

    /// The part of the scene that is seen.
    #[must_use]
    pub const fn view(&self) -> View {
        self.view
    }

    /// Changes the part of the scene that is seen, for what is painted from now on.
    pub const fn look_at(&mut self, view: View) {
        self.view = view;
    }

    /// Some of its pixels, to be filled.
    pub(super) const fn part(&mut self, clip: Clip) -> Part<'_, W> {
        Part {
            rows: &mut self.pixels,
            clip,
        }
    }

    /// Takes over some pixels of another.
    pub(super) fn copy(&mut self, other: &Self, clip: Clip) {
        let rows = self.pixels.iter_mut().zip(&other.pixels);
        let rows = rows.skip(clip.top).take(clip.bottom - clip.top);
        for (row, other) in rows {
            let columns = clip.left..clip.right;
            if let (Some(row), Some(other)) = (row.get_mut(columns.clone()), other.get(columns)) {
                row.copy_from_slice(other);
            }
        }
    }

    fn all(&mut self) -> Part<'_, W> {
        self.part(Clip::all(W, H))
    }
}

impl<T: Scalar, const W: usize, const H: usize> Canvas<T> for Frame<W, H> {
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8) {
        let projection = self.view.projection(W, H);
        paint::outline(&mut self.all(), projection, outline, pose, color);
    }

    fn text(&mut self, place: [T; 2], text: &str, color: u8) {
        let place = self.view.projection(W, H).point(place);
        paint::text(&mut self.all(), place, text, color);
    }

    fn scale(&self) -> T {
        Real::from_f64(self.view.scale())
    }
}

/// Some of the pixels of a frame.
pub(super) struct Part<'f, const W: usize> {
    rows: &'f mut [[u8; W]],
    clip: Clip,
}

impl<const W: usize> Spans for Part<'_, W> {
    fn clip(&self) -> Clip {
        self.clip
    }

    #[inline]
    fn fill(&mut self, row: usize, columns: Range<usize>, color: u8) {
        let row = self.rows.get_mut(row);
        if let Some(pixels) = row.and_then(|row| row.get_mut(columns)) {
            pixels.fill(color);
        }
    }
}

impl<const W: usize, const H: usize> Default for Frame<W, H> {
    fn default() -> Self {
        Self::new()
    }
}

/// Its size and view: nobody wants to read the pixels.
impl<const W: usize, const H: usize> fmt::Debug for Frame<W, H> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Frame<{W}, {H}>")?;
        f.debug_struct("")
            .field("view", &self.view)
            .finish_non_exhaustive()
    }
}
