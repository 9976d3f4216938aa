//! A picture in memory.

use super::memory::{Array, Grid, Memory};
#[cfg(feature = "std")]
use super::memory::{Block, Heap, TooLarge};
use super::picture::picture;
#[cfg(feature = "std")]
use super::picture::picture_of_mechanism;
use super::spans::{Clip, Spans};
use super::{Canvas, Palette, View, paint};
#[cfg(feature = "std")]
use crate::Mechanism;
use crate::{Outline, Pose, Real, Scalar};
use core::fmt;
use core::ops::Range;

/// A picture of `W` × `H` pixels with a palette and a view of the scene. A pixel takes a byte.
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
/// A frame takes `W` × `H` bytes, 768 bytes for its palette, and its view. A local variable lies on the stack;
/// `Box::new(Frame::new())` may build it there too. A large picture overflows the stack: use a static, or a `HeapFrame` (feature `std`).
///
/// The other methods are those of [`Indexed`]. Paint a picture that is too large for memory in strips. Each goes into the same small frame, with
/// a [`View`] of another part of the scene.
pub type Frame<const W: usize, const H: usize> = Indexed<Array<W, H>>;

/// A [`Frame`] on the heap, with a size chosen at run time. With feature `std`.
///
/// A pixel takes a byte: 1920 × 1080 pixels take 2.1 MB. All pixels equal those of a `Frame`. The other methods are those of [`Indexed`].
///
/// ```
/// use mech_runtime::{Canvas, HeapFrame, Outline, Palette, Pose};
///
/// let mut frame = HeapFrame::new(1920, 1080)?;
/// let disc = Outline::Circle { center: [0.0, 0.0], radius: 300.0 };
/// frame.fill(disc, Pose::identity(), Palette::BLUE);
/// assert_eq!(frame.pixel(960, 540), Some(Palette::BLUE));
/// # Ok::<(), mech_runtime::raster::TooLarge>(())
/// ```
#[cfg(feature = "std")]
pub type HeapFrame = Indexed<Heap>;

/// A picture with a palette and a view of the scene. With its pixels in an [`Array`] it is a [`Frame`], with its pixels on the `Heap` a
/// `HeapFrame` (feature `std`).
#[derive(Clone, PartialEq)]
pub struct Indexed<M: Memory> {
    pixels: M::Pixels<u8>,
    palette: Palette,
    view: View,
}

impl<const W: usize, const H: usize> Frame<W, H> {
    /// An empty picture with the [textbook](Palette::TEXTBOOK) palette. It looks at the scene's origin, with one pixel per scene unit.
    #[must_use]
    pub const fn new() -> Self {
        let () = Array::<W, H>::IS_PAINTABLE;
        Self {
            pixels: [[Palette::PAPER; W]; H],
            palette: Palette::TEXTBOOK,
            view: View::new([0.0, 0.0], 1.0),
        }
    }

    /// The entries of the palette of all pixels, row by row from the top.
    #[must_use]
    pub const fn pixels(&self) -> &[[u8; W]; H] {
        &self.pixels
    }
}

#[cfg(feature = "std")]
impl HeapFrame {
    /// An empty picture of this width and height in pixels, with the [textbook](Palette::TEXTBOOK) palette. It looks at the scene's origin,
    /// with one pixel per scene unit. Either size may be zero.
    ///
    /// # Errors
    /// [`TooLarge`] if a side exceeds 2²¹ pixels, or if there is no memory for the pixels.
    pub fn new(width: usize, height: usize) -> Result<Self, TooLarge> {
        Ok(Self {
            pixels: Block::new(Palette::PAPER, [width, height])?,
            palette: Palette::TEXTBOOK,
            view: View::default(),
        })
    }

    /// The entries of the palette of all pixels, row by row from the top.
    #[must_use]
    pub fn pixels(&self) -> &[u8] {
        self.pixels.all()
    }
}

picture!(Indexed, "Frame", u8);
#[cfg(feature = "std")]
picture_of_mechanism!(HeapFrame);

impl<M: Memory> Indexed<M> {
    /// Paints everything in colour 0.
    pub fn clear(&mut self) {
        self.pixels.all_mut().fill(Palette::PAPER);
    }

    /// The rows of pixels, to be painted.
    #[cfg(feature = "embedded-graphics")]
    pub(super) const fn grid_mut(&mut self) -> &mut M::Pixels<u8> {
        &mut self.pixels
    }

    /// The entry of a pixel. `x` counts from the left, `y` from the top. `None` outside of the picture.
    #[must_use]
    pub fn pixel(&self, x: usize, y: usize) -> Option<u8> {
        self.pixels.row(y)?.as_ref().get(x).copied()
    }

    /// Red, green and blue of a pixel. `x` counts from the left, `y` from the top. `None` outside of the picture.
    #[must_use]
    pub fn rgb(&self, x: usize, y: usize) -> Option<[u8; 3]> {
        Some(self.palette.rgb(self.pixel(x, y)?))
    }

    /// Changes the colours, also those of painted pixels.
    pub const fn set_palette(&mut self, palette: Palette) {
        self.palette = palette;
    }

    /// Some of its pixels, to be filled.
    pub(super) const fn part(&mut self, clip: Clip) -> Part<'_, M> {
        Part { pixels: &mut self.pixels, clip }
    }

    /// Copies some pixels of another.
    pub(super) fn copy(&mut self, other: &Self, clip: Clip) {
        let rows = clip.top..clip.bottom;
        let others = other.pixels.rows(rows.clone());
        for (row, other) in self.pixels.rows_mut(rows).zip(others) {
            let columns = clip.left..clip.right;
            let row = row.as_mut().get_mut(columns.clone());
            if let (Some(row), Some(other)) = (row, other.as_ref().get(columns)) {
                row.copy_from_slice(other);
            }
        }
    }

    /// All of its pixels.
    pub(super) fn whole(&self) -> Clip {
        let [width, height] = self.pixels.size();
        Clip::all(width, height)
    }

    fn all(&mut self) -> Part<'_, M> {
        self.part(self.whole())
    }
}

impl<T: Scalar, M: Memory> Canvas<T> for Indexed<M> {
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8) {
        let projection = self.view.projection(self.pixels.size());
        paint::outline(&mut self.all(), projection, outline, pose, color);
    }

    fn text(&mut self, place: [T; 2], text: &str, color: u8) {
        let place = self.view.projection(self.pixels.size()).point(place);
        paint::text(&mut self.all(), place, text, color);
    }

    fn scale(&self) -> T {
        Real::from_f64(self.view.scale())
    }
}

/// Some of the pixels of a frame.
pub(super) struct Part<'f, M: Memory> {
    pixels: &'f mut M::Pixels<u8>,
    clip: Clip,
}

impl<M: Memory> Spans for Part<'_, M> {
    fn clip(&self) -> Clip {
        self.clip
    }

    #[inline]
    fn fill(&mut self, row: usize, columns: Range<usize>, color: u8) {
        let row = self.pixels.row_mut(row);
        if let Some(pixels) = row.and_then(|row| row.as_mut().get_mut(columns)) {
            pixels.fill(color);
        }
    }
}

impl<const W: usize, const H: usize> Default for Frame<W, H> {
    fn default() -> Self {
        Self::new()
    }
}
