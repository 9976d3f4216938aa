//! Frames on displays.

use super::part;
use crate::raster::Indexed;
use crate::raster::memory::{Grid, Memory};
use crate::raster::spans::Clip;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
use embedded_graphics_core::image::ImageDrawable;
use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_graphics_core::primitives::Rectangle;

/// A frame in a display's colours, from [`Frame::image`](crate::Frame::image). `Image::new(&picture, point)` of embedded-graphics places it.
#[derive(Clone, Debug)]
pub struct Picture<'f, C, M: Memory> {
    frame: &'f Indexed<M>,
    /// The colour of each entry of the palette.
    colors: [C; 256],
}

impl<M: Memory> Indexed<M> {
    /// Shows the picture on a display, with its upper left corner at the display's (0, 0), in one call of `fill_contiguous`. Pixels beyond
    /// the display are left out. `color` converts red, green and blue to the display's colour, once for each entry of the palette.
    /// [`rgb`](super::rgb) does so.
    ///
    /// # Errors
    ///
    /// The error of the display.
    pub fn show<D: DrawTarget>(
        &self,
        display: &mut D,
        color: impl Fn([u8; 3]) -> D::Color,
    ) -> Result<(), D::Error> {
        let whole = Rectangle::new(Point::zero(), self.size());
        self.show_part(display, &whole, color)
    }

    /// Shows a part of the picture, given in pixels, where [`show`](Self::show) would show it.
    ///
    /// ```
    /// # use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
    /// use embedded_graphics::{prelude::*, primitives::Rectangle};
    /// use mech_runtime::{Frame, raster::embedded::rgb};
    ///
    /// # let mut display = MockDisplay::<Rgb888>::new();
    /// let frame = Frame::<32, 32>::new();
    /// let changed = Rectangle::new(Point::new(8, 4), Size::new(10, 20));
    /// frame.show_part(&mut display, &changed, rgb)?;
    /// # assert_eq!(display.affected_area(), changed);
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The error of the display.
    pub fn show_part<D: DrawTarget>(
        &self,
        display: &mut D,
        part: &Rectangle,
        color: impl Fn([u8; 3]) -> D::Color,
    ) -> Result<(), D::Error> {
        self.image(color).put(display, part, Point::zero())
    }

    /// The picture as an image of embedded-graphics. `color` converts red, green and blue of all 256 entries to the display's colours.
    ///
    /// ```
    /// # use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
    /// use embedded_graphics::{image::Image, prelude::*};
    /// use mech_runtime::{Frame, raster::embedded::rgb};
    ///
    /// # let mut display = MockDisplay::<Rgb888>::new();
    /// let frame = Frame::<32, 32>::new();
    /// Image::new(&frame.image(rgb), Point::new(16, 16)).draw(&mut display)?;
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    pub fn image<C>(&self, color: impl Fn([u8; 3]) -> C) -> Picture<'_, C, M> {
        let entries = self.palette().entries();
        Picture { frame: self, colors: core::array::from_fn(|entry| color(entries[entry])) }
    }
}

impl<C: PixelColor, M: Memory> Picture<'_, C, M> {
    /// Puts a part of the picture on a display. The picture's `origin` is at the display's (0, 0).
    fn put<D: DrawTarget<Color = C>>(
        &self,
        display: &mut D,
        part: &Rectangle,
        origin: Point,
    ) -> Result<(), D::Error> {
        let grid = self.frame.grid();
        let areas = [(*part, Point::zero()), (display.bounding_box(), origin)];
        let clip = part::common(areas, grid.size());
        let Clip { left, top, right, bottom } = clip;
        let places = [part::place(left, origin.x), part::place(top, origin.y)];
        let [Some(x), Some(y)] = places else {
            return Ok(());
        };
        if clip.is_empty() {
            return Ok(());
        }
        let rows = grid.rows(top..bottom);
        let entries = rows.flat_map(|row| row.as_ref().get(left..right).unwrap_or_default());
        let colors = entries.map(|&entry| self.colors[usize::from(entry)]);
        let area = part::rectangle(Point::new(x, y), 0..bottom - top, 0..right - left);
        display.fill_contiguous(&area, colors)
    }
}

impl<C, M: Memory> OriginDimensions for Picture<'_, C, M> {
    fn size(&self) -> Size {
        self.frame.size()
    }
}

impl<C: PixelColor, M: Memory> ImageDrawable for Picture<'_, C, M> {
    type Color = C;

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        self.draw_sub_image(target, &Rectangle::new(Point::zero(), self.size()))
    }

    fn draw_sub_image<D: DrawTarget<Color = C>>(
        &self,
        target: &mut D,
        area: &Rectangle,
    ) -> Result<(), D::Error> {
        // embedded-graphics wants the part at (0, 0).
        self.put(target, area, area.top_left)
    }
}
