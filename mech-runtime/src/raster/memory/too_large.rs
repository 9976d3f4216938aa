//! Why a picture could not be made.

use crate::raster::fixed;
use core::fmt;

/// A picture on the heap could not be made. Each cause tells the width and height it was to have, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TooLarge {
    /// It is wider or higher than 2²¹ pixels.
    Sides([usize; 2]),
    /// There is no memory for it.
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
