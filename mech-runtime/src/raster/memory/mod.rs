//! The memory of pictures.

mod array;
#[cfg(feature = "std")]
mod heap;
pub use array::Array;
#[cfg(feature = "std")]
pub(super) use heap::{Block, repeat};
#[cfg(feature = "std")]
pub use heap::{Heap, TooLarge};

use super::stage::Places;
use core::fmt;
use core::ops::Range;

/// The memory of a picture: an [`Array`], or with feature `std` the `Heap`. No other type implements it.
pub trait Memory: Store {}

impl<S: Store> Memory for S {}

/// The types of the parts of a picture.
pub trait Store: Clone + fmt::Debug + PartialEq {
    /// The prefix of the names of its pictures.
    const PREFIX: &'static str;
    /// All pixels.
    type Pixels<P: Copy + PartialEq>: Grid<P> + Clone + PartialEq;
    /// A number for each pixel of a row.
    type Gains: AsRef<[f32]> + AsMut<[f32]> + Clone;
    /// The items of a stage: of arrays, `N`.
    type Places<const N: usize>: Places + Clone;
}

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
