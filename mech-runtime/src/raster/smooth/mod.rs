//! Anti-aliasing: how much of each pixel a shape covers.

mod clipped;
mod cover;
mod descent;
mod disc;
mod flank;
mod mixing;
mod round;
mod runs;
mod side;
mod simple;

use super::paint::{self, Fill};
use super::polygon::Rule;
use super::spans::{Clip, Spans};
use super::{Canvas, Palette, View};
use crate::{Outline, Pose, Real, Scalar};
use clipped::Clipped;
use core::fmt;
use core::ops::Range;
use cover::Cover;
use disc::Disc;
use round::Round;
use simple::Simple;

/// Rows of a polygon that are looked at together.
const ROWS: usize = 16;

/// A picture `W` pixels wide and `H` high with soft edges: red, green, blue and opacity of each pixel.
///
/// It is painted on as a [`Frame`](super::Frame) is, with the colours that its palette has at that time. Of a pixel that a shape
/// covers in part, that part takes the shape's colour: exact to 1/255 for circles and for polygons whose sides do not cross each
/// other. Where they do, the pixel in which they cross takes the mean of how often it is surrounded. Shapes that share an edge let
/// some of what is behind them shine through along it: for them, a `Frame` is exact.
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
#[derive(Clone)]
pub struct Smooth<const W: usize, const H: usize> {
    pixels: [[[u8; 4]; W]; H],
    palette: Palette,
    view: View,
    /// Empty between two shapes.
    covers: [Cover<W>; ROWS],
}

impl<const W: usize, const H: usize> Smooth<W, H> {
    /// An empty picture, with the [textbook](Palette::TEXTBOOK) palette, that looks at the scene's origin with one pixel
    /// a unit.
    #[must_use]
    pub const fn new() -> Self {
        let palette = Palette::TEXTBOOK;
        Self {
            pixels: [[palette.rgba(Palette::PAPER); W]; H],
            palette,
            view: View::new([0.0, 0.0], 1.0),
            covers: [const { Cover::new() }; ROWS],
        }
    }

    /// Paints everything in colour 0.
    pub fn clear(&mut self) {
        let paper = self.palette.rgba(Palette::PAPER);
        self.pixels.as_flattened_mut().fill(paper);
    }

    /// The pixels: red, green, blue and opacity, row by row from the top.
    #[must_use]
    pub const fn pixels(&self) -> &[[[u8; 4]; W]; H] {
        &self.pixels
    }

    /// A pixel's red, green, blue and opacity; `x` counts from the left, `y` from the top.
    #[must_use]
    pub fn pixel(&self, x: usize, y: usize) -> Option<[u8; 4]> {
        self.pixels.get(y)?.get(x).copied()
    }

    /// The colours.
    #[must_use]
    pub const fn palette(&self) -> &Palette {
        &self.palette
    }

    /// Changes the colours, for what is painted from now on.
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
}

impl<const W: usize, const H: usize> Default for Smooth<W, H> {
    fn default() -> Self {
        Self::new()
    }
}

/// The same pixels, colours and view.
impl<const W: usize, const H: usize> PartialEq for Smooth<W, H> {
    fn eq(&self, other: &Self) -> bool {
        self.pixels == other.pixels && self.palette == other.palette && self.view == other.view
    }
}

/// Its size and view: nobody wants to read the pixels.
impl<const W: usize, const H: usize> fmt::Debug for Smooth<W, H> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Smooth<{W}, {H}>")?;
        f.debug_struct("")
            .field("view", &self.view)
            .finish_non_exhaustive()
    }
}

impl<T: Scalar, const W: usize, const H: usize> Canvas<T> for Smooth<W, H> {
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8) {
        let projection = self.view.projection(W, H);
        paint::outline(self, projection, outline, pose, color);
    }

    fn text(&mut self, place: [T; 2], text: &str, color: u8) {
        let place = self.view.projection(W, H).point(place);
        let mut dots = Dots {
            rows: &mut self.pixels,
            palette: &self.palette,
        };
        paint::text(&mut dots, place, text, color);
    }

    fn scale(&self) -> T {
        Real::from_f64(self.view.scale())
    }
}

impl<const W: usize, const H: usize> Smooth<W, H> {
    /// Paints a row by what covers it, and forgets that.
    #[inline]
    fn paint(&mut self, row: usize, place: usize, rule: Rule, paint: [u8; 4]) {
        if let (Some(pixels), Some(cover)) = (self.pixels.get_mut(row), self.covers.get_mut(place))
        {
            cover.settle(rule, pixels, paint);
        }
    }

    /// Paints some of the rows in which a circle is seen, but for a hole with the same centre, if there is one.
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
        let holes = round::rows(center, hole, H);
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
        let Some(clipped) = Clipped::new(corners, H) else {
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

impl<const W: usize, const H: usize> Fill for Smooth<W, H> {
    // An error of a 512th of a pixel.
    const FINENESS: f32 = 50.3;

    fn ring<T: Scalar>(&mut self, center: [T; 2], radius: T, hole: T, color: u8) {
        if !(Real::is_finite(hole) && hole < radius) {
            return;
        }
        let rows = round::rows(center, radius, H);
        let paint = self.palette.rgba(color);
        let Some(disc) = Disc::new(center, radius, W).filter(|_| hole <= T::ZERO) else {
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
        if let Some(simple) = Simple::new(corner, count, H) {
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
struct Dots<'f, const W: usize> {
    rows: &'f mut [[[u8; 4]; W]],
    palette: &'f Palette,
}

impl<const W: usize> Spans for Dots<'_, W> {
    fn clip(&self) -> Clip {
        Clip::all(W, self.rows.len())
    }

    fn fill(&mut self, row: usize, columns: Range<usize>, color: u8) {
        let row = self.rows.get_mut(row);
        if let Some(pixels) = row.and_then(|row| row.get_mut(columns)) {
            pixels.fill(self.palette.rgba(color));
        }
    }
}
