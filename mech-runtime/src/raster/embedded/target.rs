//! A frame that embedded-graphics draws on.

use super::Entry;
use super::part;
use crate::raster::Indexed;
use crate::raster::memory::{Grid, Memory};
use crate::raster::spans::{Clip, Spans};
use core::convert::Infallible;
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Size};
use embedded_graphics_core::primitives::Rectangle;

/// In pixels.
impl<M: Memory> OriginDimensions for Indexed<M> {
    fn size(&self) -> Size {
        // Larger ones overflow when embedded-graphics counts with them.
        let side = |pixels| i32::try_from(pixels).unwrap_or(i32::MAX).unsigned_abs();
        Size::new(side(self.width()), side(self.height()))
    }
}

/// Colours are entries of the palette; what is outside is not drawn. (`clear` of the trait takes a colour and has to be called as
/// `DrawTarget::clear(&mut frame, Entry(0))`, beside the frame's own.)
impl<M: Memory> DrawTarget for Indexed<M> {
    type Color = Entry;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Entry>>,
    {
        let rows = self.grid_mut();
        for Pixel(point, Entry(entry)) in pixels {
            let (Ok(x), Ok(y)) = (usize::try_from(point.x), usize::try_from(point.y)) else {
                continue;
            };
            if let Some(pixel) = rows.row_mut(y).and_then(|row| row.as_mut().get_mut(x)) {
                *pixel = entry;
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Entry>,
    {
        let clip = part::of(area, self.grid().size());
        if clip.is_empty() {
            return Ok(());
        }
        let Clip { left, top, right, bottom } = clip;
        let mut colors = colors.into_iter();
        let width = u64::from(area.size.width);
        let outside = before(area.top_left.y) * width + before(area.top_left.x);
        skip(&mut colors, outside);
        let beside = width - (right - left) as u64;
        for row in self.grid_mut().rows_mut(top..bottom) {
            let pixels = row.as_mut().get_mut(left..right).unwrap_or_default();
            for (pixel, Entry(entry)) in pixels.iter_mut().zip(&mut colors) {
                *pixel = entry;
            }
            skip(&mut colors, beside);
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, Entry(entry): Entry) -> Result<(), Infallible> {
        let clip = part::of(area, self.grid().size());
        let mut part = self.part(clip);
        for row in clip.top..clip.bottom {
            Spans::fill(&mut part, row, clip.left..clip.right, entry);
        }
        Ok(())
    }

    fn clear(&mut self, Entry(entry): Entry) -> Result<(), Infallible> {
        self.grid_mut().all_mut().fill(entry);
        Ok(())
    }
}

/// The number of rows or columns of a rectangle before those of the picture.
const fn before(start: i32) -> u64 {
    if start < 0 { start.unsigned_abs() as u64 } else { 0 }
}

/// Skips so many colours.
fn skip(colors: &mut impl Iterator<Item = Entry>, count: u64) {
    let mut left = count;
    while left > 0 {
        let some = usize::try_from(left).unwrap_or(usize::MAX);
        if colors.nth(some - 1).is_none() {
            return;
        }
        left -= some as u64;
    }
}
