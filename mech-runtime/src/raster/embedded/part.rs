//! Parts of pictures. Rectangles may have any place and size, so their own arithmetic could overflow.

use super::super::spans::Clip;
use super::super::stage::Area;
use core::ops::Range;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

/// The pixels of a picture that lie in a rectangle.
pub(super) fn of(area: &Rectangle, size: [usize; 2]) -> Clip {
    common([(*area, Point::zero())], size)
}

/// The pixels of a picture that lie in all these rectangles, each with its offset.
pub(super) fn common<const N: usize>(
    areas: [(Rectangle, Point); N],
    [width, height]: [usize; 2],
) -> Clip {
    let columns = areas.map(|(area, offset)| (area.top_left.x, offset.x, area.size.width));
    let rows = areas.map(|(area, offset)| (area.top_left.y, offset.y, area.size.height));
    let [columns, rows] = [within(columns, width), within(rows, height)];
    Clip { left: columns.start, top: rows.start, right: columns.end, bottom: rows.end }
}

/// The numbers of `0..count` that lie in all these ranges, each given by its beginning, its offset and its length.
fn within<const N: usize>(ranges: [(i32, i32, u32); N], count: usize) -> Range<usize> {
    let mut common = 0..count;
    for (start, offset, length) in ranges {
        let start = i64::from(start) + i64::from(offset);
        // A negative bound becomes 0. No picture is larger than a `usize`.
        let [start, end] = [start, start + i64::from(length)]
            .map(|bound| usize::try_from(bound.max(0)).unwrap_or(usize::MAX));
        common = common.start.max(start)..common.end.min(end);
    }
    common.start.min(common.end)..common.end
}

/// The distance of a row or column of a picture from this one, if a display can have it.
pub(super) fn place(index: usize, from: i32) -> Option<i32> {
    let index = i64::try_from(index).ok()?;
    i32::try_from(index - i64::from(from)).ok()
}

/// Some pixels of a picture whose upper left corner is at a place of the display.
pub(super) fn rectangle(corner: Point, rows: Range<usize>, columns: Range<usize>) -> Rectangle {
    let at = |from: i32, index| from.saturating_add(i32::try_from(index).unwrap_or(i32::MAX));
    let side = |range: Range<usize>| u32::try_from(range.len()).unwrap_or(u32::MAX);
    Rectangle::new(
        Point::new(at(corner.x, columns.start), at(corner.y, rows.start)),
        Size::new(side(columns), side(rows)),
    )
}

/// The same rectangle on a display, cut to the largest display.
impl From<Area> for Rectangle {
    fn from(area: Area) -> Self {
        let at = |index| i32::try_from(index).unwrap_or(i32::MAX);
        let side = |count| u32::try_from(count).unwrap_or(u32::MAX);
        Self::new(
            Point::new(at(area.x), at(area.y)),
            Size::new(side(area.width), side(area.height)),
        )
    }
}
