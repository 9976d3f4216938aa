//! A display that remembers what it shows.

use core::convert::Infallible;
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
use embedded_graphics_core::pixelcolor::{IntoStorage, Rgb565};
use embedded_graphics_core::primitives::Rectangle;

/// A display of 240 by 240 pixels in 16 bits, as an ST7789 has them: in memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Panel {
    pixels: [[u16; Self::SIDE]; Self::SIDE],
}

impl Panel {
    /// Its width and height, in pixels.
    pub const SIDE: usize = 240;

    /// All black.
    #[must_use]
    #[expect(
        clippy::large_stack_arrays,
        reason = "in a static, where it belongs, it never is on the stack"
    )]
    pub const fn new() -> Self {
        Self { pixels: [[0; Self::SIDE]; Self::SIDE] }
    }

    /// A check sum of all its pixels (FNV-1a).
    #[must_use]
    pub fn sum(&self) -> u64 {
        sum(self.pixels.iter().flatten().copied())
    }

    fn set(&mut self, point: Point, color: u16) {
        let [x, y] = [point.x, point.y].map(|at| usize::try_from(at).unwrap_or(usize::MAX));
        if let Some(pixel) = self.pixels.get_mut(y).and_then(|row| row.get_mut(x)) {
            *pixel = color;
        }
    }
}

impl Default for Panel {
    fn default() -> Self {
        Self::new()
    }
}

impl OriginDimensions for Panel {
    fn size(&self) -> Size {
        Size::new_equal(240)
    }
}

impl DrawTarget for Panel {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        for Pixel(point, color) in pixels {
            self.set(point, color.into_storage());
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb565) -> Result<(), Infallible> {
        let range = |start: i32, length: u32| {
            let end = i64::from(start) + i64::from(length);
            let inside = |at: i64| usize::try_from(at).unwrap_or(0).min(Self::SIDE);
            let first = inside(i64::from(start));
            (first, inside(end).saturating_sub(first))
        };
        let (left, width) = range(area.top_left.x, area.size.width);
        let (top, height) = range(area.top_left.y, area.size.height);
        for row in self.pixels.iter_mut().skip(top).take(height) {
            for pixel in row.iter_mut().skip(left).take(width) {
                *pixel = color.into_storage();
            }
        }
        Ok(())
    }
}

/// A check sum of numbers (FNV-1a, low bytes first).
pub fn sum(numbers: impl IntoIterator<Item = u16>) -> u64 {
    const START: u64 = 0xcbf2_9ce4_8422_2325;
    const FACTOR: u64 = 0x0000_0100_0000_01b3;
    numbers.into_iter().fold(START, |sum, number| {
        let bytes = number.to_le_bytes();
        bytes.iter().fold(sum, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(FACTOR))
    })
}
