//! Colours of a frame for embedded-graphics.

use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_graphics_core::pixelcolor::raw::{RawData, RawU8};

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
