//! The error of pictures that are too large.

use crate::raster::fixed;
use core::fmt;

/// The error of a picture on the heap that could not be made, with its width and height in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TooLarge {
    /// A side exceeds 2²¹ pixels.
    Sides([usize; 2]),
    /// There is no memory for the pixels.
    Memory([usize; 2]),
}

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sides([width, height]) => write!(
                f,
                "a picture of {width} × {height} pixels has more than {} in one direction",
                fixed::MOST
            ),
            Self::Memory([width, height]) => {
                write!(
                    f,
                    "there is no memory for a picture of {width} × {height} pixels"
                )
            }
        }
    }
}

impl core::error::Error for TooLarge {}
