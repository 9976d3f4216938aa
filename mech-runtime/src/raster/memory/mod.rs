//! What a picture keeps its pixels in.

mod array;
mod grid;
#[cfg(feature = "std")]
mod heap;
#[cfg(feature = "std")]
mod too_large;

pub use array::Array;
pub(crate) use grid::Grid;
#[cfg(feature = "std")]
pub use heap::Heap;
#[cfg(feature = "std")]
pub(super) use heap::{Block, filled};
#[cfg(feature = "std")]
pub use too_large::TooLarge;

use super::stage::Places;
use core::fmt;

/// What a picture keeps its pixels in: an [`Array`], or with feature `std` the `Heap`. Nothing else can be one.
pub trait Memory: Store {}

impl<S: Store> Memory for S {}

/// What the parts of a picture are kept in.
pub trait Store: Clone + fmt::Debug + PartialEq {
    /// What the names of its pictures begin with.
    const PREFIX: &'static str;
    /// All pixels.
    type Pixels<P: Copy + PartialEq>: Grid<P> + Clone + PartialEq;
    /// A number for each pixel of a row.
    type Gains: AsRef<[f32]> + AsMut<[f32]> + Clone;
    /// The things that a stage keeps account of: of arrays, `N`.
    type Places<const N: usize>: Places + Clone;
}
