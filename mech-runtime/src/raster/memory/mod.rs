//! The memory of pictures.

mod array;
mod grid;
#[cfg(feature = "std")]
mod heap;
pub use array::Array;
pub(crate) use grid::Grid;
#[cfg(feature = "std")]
pub(super) use heap::{Block, repeat};
#[cfg(feature = "std")]
pub use heap::{Heap, TooLarge};

use super::stage::Places;
use core::fmt;

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
