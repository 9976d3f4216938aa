//! A picture in memory.

use super::memory::{Array, Grid, Memory};
#[cfg(feature = "std")]
use super::memory::{Block, Heap, TooLarge};
use super::spans::{Clip, Spans};
use super::{Canvas, Palette, View, paint};
#[cfg(feature = "std")]
use crate::Mechanism;
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
/// It takes `W` × `H` bytes, 768 for its palette, and its view. In a variable it lies on the stack. `Box::new(Frame::new())` makes it
/// there too, unless that is optimised away. A large picture overflows the stack: make it in a static, or as a `HeapFrame` (feature
/// `std`).
///
/// Besides the methods here it has those of every [`Indexed`] picture. A picture too large for memory can be painted in strips, each in the same small frame with a
/// [`View`] that looks at another part of the scene.
pub type Frame<const W: usize, const H: usize> = Indexed<Array<W, H>>;

/// A [`Frame`] of a size that is told at run time, on the heap: for pictures of any size. With feature `std`.
///
/// It takes a byte a pixel on the heap: 2.1 MB for 1920 × 1080 pixels. It is painted on as a `Frame` is, and looks the same, pixel for
/// pixel. Besides the methods here it has those of every [`Indexed`] picture.
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

/// A picture of a byte a pixel, with a palette and a view of the scene. With its pixels in an [`Array`] it is a [`Frame`], with its
/// pixels on the `Heap` a `HeapFrame` (feature `std`).
#[derive(Clone, PartialEq)]
pub struct Indexed<M: Memory> {
    pixels: M::Pixels<u8>,
    palette: Palette,
    view: View,
}

impl<const W: usize, const H: usize> Frame<W, H> {
    /// An empty picture, with the [textbook](Palette::TEXTBOOK) palette, that looks at the scene's origin with one pixel
    /// a unit.
    #[must_use]
    pub const fn new() -> Self {
        let () = Array::<W, H>::IS_PAINTABLE;
        Self {
            pixels: [[Palette::PAPER; W]; H],
            palette: Palette::TEXTBOOK,
            view: View::new([0.0, 0.0], 1.0),
        }
    }

    /// The pixels, each an entry of the palette, row by row from the top.
    #[must_use]
    pub const fn pixels(&self) -> &[[u8; W]; H] {
        &self.pixels
    }
}

#[cfg(feature = "std")]
impl HeapFrame {
    /// An empty picture so many pixels wide and high, with the [textbook](Palette::TEXTBOOK) palette, that looks at the scene's
    /// origin with one pixel a unit. Either size may be zero.
    ///
    /// # Errors
    /// [`TooLarge`] if it is wider or higher than 2²¹ pixels, or if there is no memory for it.
    pub fn new(width: usize, height: usize) -> Result<Self, TooLarge> {
        Ok(Self {
            pixels: Block::new(Palette::PAPER, [width, height])?,
            palette: Palette::TEXTBOOK,
            view: View::default(),
        })
    }

    /// The same for a mechanism: it looks at all of it, wherever its motors move it.
    ///
    /// # Errors
    /// [`TooLarge`] if it is wider or higher than 2²¹ pixels, or if there is no memory for it.
    pub fn of<A: Mechanism>(width: usize, height: usize) -> Result<Self, TooLarge> {
        let mut frame = Self::new(width, height)?;
        frame.look_at(A::view(width, height));
        Ok(frame)
    }

    /// The pixels, each an entry of the palette, row by row from the top.
    #[must_use]
    pub fn pixels(&self) -> &[u8] {
        self.pixels.all()
    }
}

impl<M: Memory> Indexed<M> {
    /// Paints everything in colour 0.
    pub fn clear(&mut self) {
        self.pixels.all_mut().fill(Palette::PAPER);
    }

    /// How many pixels it is wide.
    #[must_use]
    pub fn width(&self) -> usize {
        self.pixels.size()[0]
    }

    /// How many pixels it is high.
    #[must_use]
    pub fn height(&self) -> usize {
        self.pixels.size()[1]
    }

    /// What keeps the pixels.
    pub(crate) const fn grid(&self) -> &M::Pixels<u8> {
        &self.pixels
    }

    /// What keeps the pixels, to be painted.
    #[cfg(feature = "embedded-graphics")]
    pub(super) const fn grid_mut(&mut self) -> &mut M::Pixels<u8> {
        &mut self.pixels
    }

    /// A pixel's entry in the palette; `x` counts from the left, `y` from the top.
    #[must_use]
    pub fn pixel(&self, x: usize, y: usize) -> Option<u8> {
        self.pixels.row(y)?.as_ref().get(x).copied()
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
    pub(super) const fn part(&mut self, clip: Clip) -> Part<'_, M> {
        Part {
            pixels: &mut self.pixels,
            clip,
        }
    }

    /// Takes over some pixels of another.
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

/// Its size and view: nobody wants to read the pixels.
impl<M: Memory> fmt::Debug for Indexed<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [width, height] = self.pixels.size();
        write!(f, "{}Frame<{width}, {height}>", M::PREFIX)?;
        f.debug_struct("")
            .field("view", &self.view)
            .finish_non_exhaustive()
    }
}
