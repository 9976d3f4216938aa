//! What pictures are filled with: spans of pixels in one row.

use core::ops::Range;

/// Something that is filled span by span.
pub(super) trait Spans {
    /// The pixels that may be filled.
    fn clip(&self) -> Clip;

    /// Fills the pixels `columns` of a row with entry `color` of the palette; both lie within the clip.
    fn fill(&mut self, row: usize, columns: Range<usize>, color: u8);
}

/// A rectangle of pixels: columns from the left, rows from the top; the right and the bottom are not in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Clip {
    pub(super) left: usize,
    pub(super) top: usize,
    pub(super) right: usize,
    pub(super) bottom: usize,
}

impl Clip {
    /// All of a picture.
    pub(super) const fn all(width: usize, height: usize) -> Self {
        Self {
            left: 0,
            top: 0,
            right: width,
            bottom: height,
        }
    }
}
