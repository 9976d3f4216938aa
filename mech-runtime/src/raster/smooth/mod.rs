//! Anti-aliasing: the share of each pixel that a shape covers.

mod clipped;
mod cover;
mod disc;
mod flank;
mod mixing;
mod round;
mod runs;
mod side;
mod simple;

use super::crossings::Rule;
use super::memory::{Array, Grid, Memory};
#[cfg(feature = "std")]
use super::memory::{Block, Heap, TooLarge, repeat};
use super::paint::{self, Fill};
use super::picture::picture;
#[cfg(feature = "std")]
use super::picture::picture_of_mechanism;
use super::spans::{Clip, Spans};
use super::{Canvas, Palette, View};
#[cfg(feature = "std")]
use crate::Mechanism;
use crate::{Outline, Pose, Real, Scalar};
use clipped::Clipped;
use core::fmt;
use core::ops::Range;
use cover::Cover;
use disc::Disc;
use round::Round;
use simple::Simple;
#[cfg(feature = "std")]
use std::vec::Vec;

/// Rows of a polygon that are looked at together.
const ROWS: usize = 16;

/// A picture of `W` × `H` pixels with anti-aliased edges: red, green, blue and opacity of each pixel.
///
/// It is painted like a [`Frame`](super::Frame), with the present colours of its palette. A pixel that a shape covers in part takes this
/// part of the shape's colour. The part is exact to 1/255 for circles, and for polygons whose sides do not cross. A pixel in which two
/// sides cross takes the mean winding number. Where two shapes share an edge, the background shines through. There a `Frame` is exact.
///
/// ```
/// use mech_runtime::{Canvas, Outline, Palette, Pose, Smooth, View};
///
/// let mut picture = Smooth::<32, 32>::new();
/// picture.look_at(View::new([0.0, 0.0], 1.0));
/// let disc = Outline::Circle { center: [0.0, 0.0], radius: 12.25 };
/// picture.fill(disc, Pose::identity(), Palette::INK);
/// let [red, ..] = picture.pixel(28, 16).unwrap_or_default();
/// assert!(0x2A < red && red < 0xFA); // between ink and paper
/// ```
///
/// A pixel takes four bytes, and so does each pixel of 16 hidden rows: 4 × `W` × (`H` + 16). The palette takes 768 bytes, the rows 1.1 KiB
/// more. A local variable lies on the stack; `Box::new(Smooth::new())` may build it there too. A large picture overflows the stack:
/// use a static, or a `HeapSmooth` (feature `std`).
///
/// The other methods are those of [`Soft`].
pub type Smooth<const W: usize, const H: usize> = Soft<Array<W, H>>;

/// A [`Smooth`] on the heap, with a size chosen at run time. With feature `std`.
///
/// A pixel takes four bytes, and so does each pixel of 16 hidden rows: 1920 × 1080 pixels take 8.4 MB. All pixels equal those of a `Smooth`.
/// Beyond 32,768 pixels from the left, the error may exceed 1/255. The other methods are those of [`Soft`].
///
/// ```
/// use mech_runtime::{HeapSmooth, Mechanism, mechanism};
///
/// mechanism! {
///     struct Arm;
///     link upper { bar [(0, 0), (2, 0)] width 0.4; }
///     link lower { bar [(2, 0), (3.5, 0)] width 0.3; }
///     joint shoulder = revolute(ground, upper) at (0, 0);
///     joint elbow = revolute(upper, lower) at (2, 0);
///     motor shoulder; motor elbow;
/// }
/// let mut arm = Arm::new();
/// arm.move_to([0.5, 1.0])?;
/// let mut picture = HeapSmooth::of::<Arm>(1920, 1080)?; // looks at all that the arm reaches
/// arm.draw(&mut picture);
/// assert_eq!(picture.view(), Arm::view(1920, 1080));
/// let file = picture.png()?; // for `std::fs::write("arm.png", file)`
/// assert!(file.starts_with(b"\x89PNG"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[cfg(feature = "std")]
pub type HeapSmooth = Soft<Heap>;

/// A picture in true colour with anti-aliased edges and a view of the scene. With its pixels in an [`Array`] it is a [`Smooth`], with its
/// pixels on the `Heap` a `HeapSmooth` (feature `std`).
#[derive(Clone)]
pub struct Soft<M: Memory> {
    pixels: M::Pixels<[u8; 4]>,
    palette: Palette,
    view: View,
    /// Empty between two shapes.
    covers: [Cover<M::Gains>; ROWS],
}

/// The colour of empty pixels until the palette is changed.
const PAPER: [u8; 4] = Palette::TEXTBOOK.rgba(Palette::PAPER);

impl<const W: usize, const H: usize> Smooth<W, H> {
    /// An empty picture with the [textbook](Palette::TEXTBOOK) palette. It looks at the scene's origin, with one pixel per scene unit.
    #[must_use]
    pub const fn new() -> Self {
        let () = Array::<W, H>::IS_PAINTABLE;
        Self {
            pixels: [[PAPER; W]; H],
            palette: Palette::TEXTBOOK,
            view: View::new([0.0, 0.0], 1.0),
            covers: [const { Cover::new([0.0; W]) }; ROWS],
        }
    }

    /// Red, green, blue and opacity of all pixels, row by row from the top.
    #[must_use]
    pub const fn pixels(&self) -> &[[[u8; 4]; W]; H] {
        &self.pixels
    }
}

#[cfg(feature = "std")]
impl HeapSmooth {
    /// An empty picture of this width and height in pixels, with the [textbook](Palette::TEXTBOOK) palette. It looks at the scene's origin,
    /// with one pixel per scene unit. Either size may be zero.
    ///
    /// # Errors
    /// [`TooLarge`] if a side exceeds 2²¹ pixels, or if there is no memory for the pixels.
    pub fn new(width: usize, height: usize) -> Result<Self, TooLarge> {
        let size = [width, height];
        let pixels = Block::new(PAPER, size)?;
        let mut covers = [const { Cover::new(Vec::new()) }; ROWS];
        for cover in &mut covers {
            *cover = Cover::new(repeat(0.0, width).ok_or(TooLarge::Memory(size))?);
        }
        Ok(Self { pixels, palette: Palette::TEXTBOOK, view: View::default(), covers })
    }

    /// Red, green, blue and opacity of all pixels, row by row from the top.
    #[must_use]
    pub fn pixels(&self) -> &[[u8; 4]] {
        self.pixels.all()
    }
}

picture!(Soft, "Smooth", [u8; 4]);
#[cfg(feature = "std")]
picture_of_mechanism!(HeapSmooth);

impl<M: Memory> Soft<M> {
    /// Paints everything in colour 0.
    pub fn clear(&mut self) {
        let paper = self.palette.rgba(Palette::PAPER);
        self.pixels.all_mut().fill(paper);
    }

    /// Red, green, blue and opacity of a pixel. `x` counts from the left, `y` from the top. `None` outside of the picture.
    #[must_use]
    pub fn pixel(&self, x: usize, y: usize) -> Option<[u8; 4]> {
        self.pixels.row(y)?.as_ref().get(x).copied()
    }

    /// Changes the colours of all that is painted from now on.
    pub const fn set_palette(&mut self, palette: Palette) {
        self.palette = palette;
    }
}

impl<const W: usize, const H: usize> Default for Smooth<W, H> {
    fn default() -> Self {
        Self::new()
    }
}

/// The same pixels, colours and view.
impl<M: Memory> PartialEq for Soft<M> {
    fn eq(&self, other: &Self) -> bool {
        self.pixels == other.pixels && self.palette == other.palette && self.view == other.view
    }
}

impl<T: Scalar, M: Memory> Canvas<T> for Soft<M> {
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8) {
        let projection = self.view.projection(self.pixels.size());
        paint::outline(self, projection, outline, pose, color);
    }

    fn text(&mut self, place: [T; 2], text: &str, color: u8) {
        let place = self.view.projection(self.pixels.size()).point(place);
        let mut dots = Dots { pixels: &mut self.pixels, palette: &self.palette };
        paint::text(&mut dots, place, text, color);
    }

    fn scale(&self) -> T {
        Real::from_f64(self.view.scale())
    }
}

impl<M: Memory> Soft<M> {
    /// Paints a row by its coverage, and clears that.
    #[inline]
    fn paint(&mut self, row: usize, place: usize, rule: Rule, paint: [u8; 4]) {
        if let (Some(pixels), Some(cover)) = (self.pixels.row_mut(row), self.covers.get_mut(place))
        {
            cover.settle(rule, pixels, paint);
        }
    }

    /// Paints some rows of a circle, except for a hole with the same centre, if there is one.
    fn around<T: Scalar>(
        &mut self,
        center: [T; 2],
        [radius, hole]: [T; 2],
        rows: Range<usize>,
        paint: [u8; 4],
    ) {
        if rows.is_empty() {
            return;
        }
        let mut outer = Round::new(center, radius, rows.start, Self::FINENESS);
        let holes = round::rows(center, hole, self.height());
        let mut inner = None;
        for row in rows {
            let [cover, ..] = &mut self.covers;
            outer.cover(row, 1.0, cover);
            if holes.contains(&row) {
                inner
                    .get_or_insert_with(|| Round::new(center, hole, row, Self::FINENESS))
                    .cover(row, -1.0, cover);
            }
            self.paint(row, 0, Rule::NonZero, paint);
        }
    }

    fn path_by<T: Scalar>(
        &mut self,
        corners: &(impl Iterator<Item = [T; 2]> + Clone),
        rule: Rule,
        color: u8,
    ) {
        let Some(clipped) = Clipped::new(corners, self.height()) else {
            return;
        };
        let paint = self.palette.rgba(color);
        let rows = clipped.rows();
        let mut top = rows.start;
        while top < rows.end {
            let bottom = rows.end.min(top + ROWS);
            if let Some(covers) = self.covers.get_mut(..bottom - top) {
                clipped.cover(corners, covers, top);
            }
            for row in top..bottom {
                self.paint(row, row - top, rule, paint);
            }
            top = bottom;
        }
    }
}

impl<M: Memory> Fill for Soft<M> {
    // An error of a 512th of a pixel.
    const FINENESS: f32 = 50.3;

    fn ring<T: Scalar>(&mut self, center: [T; 2], radius: T, hole: T, color: u8) {
        if !(Real::is_finite(hole) && hole < radius) {
            return;
        }
        let rows = round::rows(center, radius, self.height());
        let paint = self.palette.rgba(color);
        let Some(disc) = Disc::new(center, radius, self.width()).filter(|_| hole <= T::ZERO) else {
            self.around(center, [radius, hole], rows, paint);
            return;
        };
        let steep = disc.steep_rows(rows.clone());
        let poles = [rows.start..steep.start, steep.end..rows.end];
        let has_flat_poles = disc.has_flat_poles(&steep);
        for rows in poles {
            if has_flat_poles {
                disc.paint_poles(self, rows, paint);
            } else {
                self.around(center, [radius, hole], rows, paint);
            }
        }
        disc.paint_steep(self, steep, paint);
    }

    fn polygon<T: Scalar>(
        &mut self,
        corner: &(impl Fn(usize) -> [T; 2] + Clone),
        count: usize,
        rule: Rule,
        color: u8,
    ) {
        if let Some(simple) = Simple::new(corner, count, self.height()) {
            simple.paint(self, self.palette.rgba(color));
        } else {
            self.path_by(&(0..count).map(corner), rule, color);
        }
    }

    fn path<T: Scalar>(&mut self, corners: &(impl Iterator<Item = [T; 2]> + Clone), color: u8) {
        self.path_by(corners, Rule::NonZero, color);
    }
}

/// Whole pixels of a picture.
struct Dots<'f, G> {
    pixels: &'f mut G,
    palette: &'f Palette,
}

impl<G: Grid<[u8; 4]>> Spans for Dots<'_, G> {
    fn clip(&self) -> Clip {
        let [width, height] = self.pixels.size();
        Clip::all(width, height)
    }

    fn fill(&mut self, row: usize, columns: Range<usize>, color: u8) {
        let row = self.pixels.row_mut(row);
        if let Some(pixels) = row.and_then(|row| row.as_mut().get_mut(columns)) {
            pixels.fill(self.palette.rgba(color));
        }
    }
}
