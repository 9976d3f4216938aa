//! Displays as canvases.

use super::part;
use crate::raster::spans::{Clip, Spans};
use crate::raster::{fixed, paint};
use crate::{Canvas, Outline, Palette, Pose, Real, Scalar, View};
use core::fmt;
use core::ops::Range;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Point;

/// A display of embedded-graphics as a [`Canvas`], without a picture in memory. It is painted by rectangles with `fill_solid`, each pixel
/// once for each shape.
///
/// The picture is the display's bounding box. For a part of a display, use `Screen::new(&mut display.cropped(&area), …)`. At most 2²¹
/// pixels in each direction are painted.
///
/// A [`Canvas`] cannot fail, but a display can. After its first error nothing is painted, and [`finish`](Self::finish) returns the error.
#[must_use = "`finish` returns the error of the display"]
pub struct Screen<'d, D: DrawTarget, F> {
    display: &'d mut D,
    /// The upper left corner of the picture on the display.
    corner: Point,
    width: usize,
    height: usize,
    palette: &'d Palette,
    color: F,
    view: View,
    outcome: Result<(), D::Error>,
}

impl<'d, D: DrawTarget, F: Fn([u8; 3]) -> D::Color> Screen<'d, D, F> {
    /// A whole display, with the [textbook](Palette::TEXTBOOK) palette. `color` converts red, green and blue to the display's colour.
    /// [`rgb`](super::rgb) does so.
    pub fn new(display: &'d mut D, view: View, color: F) -> Self {
        let area = display.bounding_box();
        let corner = area.top_left;
        Self {
            display,
            corner,
            width: side(corner.x, area.size.width),
            height: side(corner.y, area.size.height),
            palette: const { &Palette::TEXTBOOK },
            color,
            view,
            outcome: Ok(()),
        }
    }

    /// Paints everything in colour 0.
    pub fn clear(&mut self) {
        if self.outcome.is_ok() {
            self.outcome = self.display.clear(self.color_of(Palette::PAPER));
        }
    }

    /// Ends the painting.
    ///
    /// # Errors
    ///
    /// The first error of the display.
    pub fn finish(self) -> Result<(), D::Error> {
        self.outcome
    }

    fn color_of(&self, entry: u8) -> D::Color {
        (self.color)(self.palette.rgb(entry))
    }

    /// Paints by means of something that is filled span by span.
    fn paint(&mut self, paint: impl FnOnce(&mut Strips<'_, 'd, D, F>)) {
        if self.outcome.is_ok() {
            let mut strips = Strips { screen: self, last: None };
            paint(&mut strips);
            strips.end();
        }
    }
}

impl<'d, D: DrawTarget, F> Screen<'d, D, F> {
    /// The colours.
    #[must_use]
    pub const fn palette(&self) -> &'d Palette {
        self.palette
    }

    /// Changes the colours, for what is painted from now on.
    pub const fn set_palette(&mut self, palette: &'d Palette) {
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

impl<T, D, F> Canvas<T> for Screen<'_, D, F>
where
    T: Scalar,
    D: DrawTarget,
    F: Fn([u8; 3]) -> D::Color,
{
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8) {
        let projection = self.view.projection([self.width, self.height]);
        self.paint(|strips| paint::outline(strips, projection, outline, pose, color));
    }

    fn text(&mut self, place: [T; 2], text: &str, color: u8) {
        let place = self.view.projection([self.width, self.height]).point(place);
        self.paint(|strips| paint::text(strips, place, text, color));
    }

    fn scale(&self) -> T {
        Real::from_f64(self.view.scale())
    }
}

/// Its size and view.
impl<D: DrawTarget, F> fmt::Debug for Screen<'_, D, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Screen")
            .field("width", &self.width)
            .field("height", &self.height)
            .field("view", &self.view)
            .finish_non_exhaustive()
    }
}

/// The number of painted pixels of a side of a display that begins here. Places beyond an `i32` do not exist.
fn side(start: i32, length: u32) -> usize {
    let places = i64::from(i32::MAX) - i64::from(start);
    let side = i64::from(length).min(places).min(i64::from(fixed::FAR));
    usize::try_from(side).unwrap_or(0)
}

/// Spans that become rectangles.
struct Strips<'s, 'd, D: DrawTarget, F> {
    screen: &'s mut Screen<'d, D, F>,
    /// Not on the display yet.
    last: Option<Strip>,
}

impl<D: DrawTarget, F: Fn([u8; 3]) -> D::Color> Strips<'_, '_, D, F> {
    /// Puts the last rectangle on the display.
    fn end(&mut self) {
        let Some(strip) = self.last.take() else {
            return;
        };
        if self.screen.outcome.is_ok() {
            let color = self.screen.color_of(strip.color);
            let area = part::rectangle(self.screen.corner, strip.rows, strip.columns);
            self.screen.outcome = self.screen.display.fill_solid(&area, color);
        }
    }
}

impl<D: DrawTarget, F: Fn([u8; 3]) -> D::Color> Spans for Strips<'_, '_, D, F> {
    fn clip(&self) -> Clip {
        Clip::all(self.screen.width, self.screen.height)
    }

    fn fill(&mut self, row: usize, columns: Range<usize>, color: u8) {
        if columns.is_empty() {
            return;
        }
        let next = Strip::new(row, columns, color);
        let grows = self.last.as_mut().is_some_and(|last| last.takes(&next));
        if !grows {
            self.end();
            self.last = Some(next);
        }
    }
}

/// A rectangle of one colour that may still grow.
#[derive(Clone, Debug)]
struct Strip {
    pub(super) rows: Range<usize>,
    pub(super) columns: Range<usize>,
    pub(super) color: u8,
}

impl Strip {
    pub(super) const fn new(row: usize, columns: Range<usize>, color: u8) -> Self {
        Self { rows: row..row + 1, columns, color }
    }

    /// Grows by the next span, if with it it is still a rectangle.
    pub(super) fn takes(&mut self, next: &Self) -> bool {
        if self.color != next.color {
            return false;
        }
        if self.columns == next.columns && self.rows.end == next.rows.start {
            self.rows.end = next.rows.end;
            return true;
        }
        if self.rows == next.rows && self.columns.end == next.columns.start {
            self.columns.end = next.columns.end;
            return true;
        }
        false
    }
}
