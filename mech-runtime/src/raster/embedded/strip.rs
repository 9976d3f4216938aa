//! Spans of the same columns in rows that follow each other, and spans that follow each other in a row, are one rectangle.

use core::ops::Range;

/// A rectangle of one colour that may still grow.
#[derive(Clone, Debug)]
pub(super) struct Strip {
    pub(super) rows: Range<usize>,
    pub(super) columns: Range<usize>,
    pub(super) color: u8,
}

impl Strip {
    pub(super) const fn new(row: usize, columns: Range<usize>, color: u8) -> Self {
        Self {
            rows: row..row + 1,
            columns,
            color,
        }
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
