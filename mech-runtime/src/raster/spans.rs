//! Spans of pixels in one row, which fill pictures.

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
        Self { left: 0, top: 0, right: width, bottom: height }
    }

    /// No pixel.
    pub(super) const fn none() -> Self {
        Self::all(0, 0)
    }

    /// The intersection of two rectangles.
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            left: self.left.max(other.left),
            top: self.top.max(other.top),
            right: self.right.min(other.right),
            bottom: self.bottom.min(other.bottom),
        }
    }

    /// The smallest rectangle around both.
    pub(super) fn around(self, other: Self) -> Self {
        if self.is_empty() {
            return other;
        }
        if other.is_empty() {
            return self;
        }
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
        }
    }

    /// Whether no pixel is in it.
    pub(super) const fn is_empty(self) -> bool {
        self.left >= self.right || self.top >= self.bottom
    }

    /// The number of its pixels.
    pub(super) const fn area(self) -> usize {
        if self.is_empty() { 0 } else { (self.right - self.left) * (self.bottom - self.top) }
    }
}
