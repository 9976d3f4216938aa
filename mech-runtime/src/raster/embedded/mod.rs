//! Pictures on displays, by [embedded-graphics](https://docs.rs/embedded-graphics) (feature `embedded-graphics`; still `no_std`).
//!
//! A [`Screen`] paints rectangles on the display itself. It needs no memory for pixels, but shapes that others cover are seen for a moment.
//! A [`Frame`](super::Frame) is painted in memory. One call [shows](super::Frame::show) it on the display, whole or
//! [in part](super::Frame::show_part):
//!
//! ```
//! use embedded_graphics::mock_display::MockDisplay; // or the driver of an ST7789, an SSD1306…
//! use embedded_graphics::pixelcolor::{BinaryColor, Rgb565};
//! use mech_runtime::raster::embedded::{Screen, rgb};
//! use mech_runtime::{Frame, View, mechanism};
//!
//! mechanism! {
//!     struct SliderCrank: f32;
//!     link crank; link rod;
//!     link block { circle (4, 0) radius 0.5 on plane 1 color 2; }
//!     joint a = revolute(ground, crank) at (0, 0);
//!     joint b = revolute(crank, rod) at (1, 0.5);
//!     joint c = revolute(rod, block) at (4, 0);
//!     joint x = prismatic(ground, block) at (4, 0) along (1, 0);
//!     motor a;
//! }
//! let mut slider_crank = SliderCrank::new();
//! slider_crank.move_to([0.5])?;
//! let view = View::fit([-1.5, -1.5], [5.5, 1.5], 64, 64, 2.0);
//!
//! // On the display itself.
//! # let new_display = || { let mut display = MockDisplay::<Rgb565>::new(); display.set_allow_overdraw(true); display };
//! let mut display = new_display();
//! let mut screen = Screen::new(&mut display, view, rgb);
//! screen.clear();
//! slider_crank.draw(&mut screen);
//! screen.finish()?;
//!
//! // On a frame, and then on the display: the same pixels.
//! # let mut other = new_display();
//! let mut frame = Frame::<64, 64>::new();
//! frame.look_at(view);
//! slider_crank.draw(&mut frame);
//! frame.show(&mut other, rgb)?;
//! # other.assert_eq(&display);
//!
//! // Dark pixels are lit on a display of two tones.
//! # let mut two_tone = MockDisplay::<BinaryColor>::new();
//! frame.show(&mut two_tone, |[red, green, blue]| {
//!     BinaryColor::from(u16::from(red) + u16::from(green) + u16::from(blue) < 384)
//! })?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! With a [`Stage`](super::Stage) a display needs the changed rectangles only: `stage.frame().show_part(&mut display, &area.into(), rgb)` for
//! each [area](super::Stage::changed). `docs/embedded.md` in the repository describes drivers and panels.
//!
//! A frame is a [`DrawTarget`](embedded_graphics_core::draw_target::DrawTarget) whose colours are [entries](Entry) of its palette. So
//! embedded-graphics can draw texts, primitives and images beside the mechanism.

mod part;
mod picture;
mod screen;
mod target;

use embedded_graphics_core::pixelcolor::raw::{RawData, RawU8};
use embedded_graphics_core::pixelcolor::{PixelColor, Rgb888};
pub use picture::Picture;
pub use screen::Screen;

/// The display's colour nearest to red, green and blue, for every kind of colour of embedded-graphics. A light `BinaryColor` is on.
#[must_use]
pub fn rgb<C: From<Rgb888>>([red, green, blue]: [u8; 3]) -> C {
    C::from(Rgb888::new(red, green, blue))
}

/// An entry of a [palette](crate::Palette): the colour of a [`Frame`](crate::Frame) for embedded-graphics.
///
/// ```
/// use embedded_graphics::prelude::*;
/// use embedded_graphics::primitives::{Circle, PrimitiveStyle};
/// use mech_runtime::raster::embedded::Entry;
/// use mech_runtime::{Frame, Palette};
///
/// let mut frame = Frame::<32, 32>::new();
/// let blue = PrimitiveStyle::with_fill(Entry(Palette::BLUE));
/// let Ok(()) = Circle::new(Point::new(6, 6), 20).into_styled(blue).draw(&mut frame);
/// assert_eq!(frame.pixel(16, 16), Some(Palette::BLUE));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Entry(pub u8);

impl PixelColor for Entry {
    type Raw = RawU8;
}

impl From<RawU8> for Entry {
    fn from(raw: RawU8) -> Self {
        Self(raw.into_inner())
    }
}

impl From<Entry> for RawU8 {
    fn from(Entry(entry): Entry) -> Self {
        Self::new(entry)
    }
}
