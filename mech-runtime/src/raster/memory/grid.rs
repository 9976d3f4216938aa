//! Pixels in rows.

use core::ops::Range;

/// Pixels in rows of the same width. Rows of an array know theirs when they are compiled.
pub trait Grid<P> {
    /// The pixels of a row.
    type Row: AsRef<[P]> + AsMut<[P]> + ?Sized;

    /// Its width and height.
    fn size(&self) -> [usize; 2];

    /// A row, counted from the top.
    fn row(&self, y: usize) -> Option<&Self::Row>;

    /// A row to be painted, counted from the top.
    fn row_mut(&mut self, y: usize) -> Option<&mut Self::Row>;

    /// Some rows, from the top, if they exist.
    fn rows<'g>(&'g self, rows: Range<usize>) -> impl Iterator<Item = &'g Self::Row>
    where
        P: 'g;

    /// Some rows to be painted, from the top, if they exist.
    fn rows_mut<'g>(&'g mut self, rows: Range<usize>) -> impl Iterator<Item = &'g mut Self::Row>
    where
        P: 'g;

    /// All pixels, row by row from the top.
    fn all(&self) -> &[P];

    /// All pixels to be painted, row by row from the top.
    fn all_mut(&mut self) -> &mut [P];
}
