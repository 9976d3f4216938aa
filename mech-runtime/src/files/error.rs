//! The error of files.

use core::fmt;
use std::io;

/// The error of a file that could not be written.
#[derive(Debug)]
#[non_exhaustive]
pub enum FileError {
    /// The picture is 0 pixels wide or high.
    Empty,
    /// The number of pixels does not match the size.
    Torn {
        /// The width times the height.
        expected: usize,
        /// The number of pixels.
        found: usize,
    },
    /// The picture is wider or higher than this kind of file allows.
    TooLarge {
        /// The most pixels in one direction.
        most: usize,
    },
    /// A frame of an animation has another size than the first one.
    OtherSize {
        /// The width and height of the first.
        expected: [usize; 2],
        /// The width and height of this frame.
        found: [usize; 2],
    },
    /// A GIF was given a picture in true colour, not one with a palette.
    TrueColor,
    /// An animated PNG was given a picture with a palette after one in true colour, or the reverse.
    OtherKind,
    /// A frame of an animated PNG has a colour that the palette of the first one lacks.
    OtherColor([u8; 3]),
    /// The delay is longer than this kind of file allows: 655 seconds in a GIF, 65 in an animated PNG.
    TooLong,
    /// The number of frames is not the announced one.
    OtherCount {
        /// The announced number.
        announced: u32,
        /// The number of frames; one more than announced if another was to be added.
        found: u32,
    },
    /// The writer failed.
    Write(io::Error),
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("the picture has no pixels"),
            Self::Torn { expected, found } => {
                write!(f, "there are {found} pixels, where its size takes {expected}")
            }
            Self::TooLarge { most } => {
                write!(f, "the picture is more than {most} pixels wide or high")
            }
            Self::OtherSize { expected: [width, height], found } => write!(
                f,
                "the frame is {} × {} pixels, where the first one is {width} × {height}",
                found[0], found[1]
            ),
            Self::TrueColor => f.write_str("a GIF takes pictures with a palette only"),
            Self::OtherKind => {
                f.write_str("either all frames have a palette, or all are in true colour")
            }
            Self::OtherColor([red, green, blue]) => write!(
                f,
                "the palette of the first frame lacks the colour #{red:02x}{green:02x}{blue:02x}"
            ),
            Self::TooLong => f.write_str("a frame is to be seen for too long"),
            Self::OtherCount { announced, found } => {
                write!(f, "{announced} frames were announced, not {found}")
            }
            Self::Write(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for FileError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Write(error) => Some(error),
            _ => None,
        }
    }
}

impl From<io::Error> for FileError {
    fn from(error: io::Error) -> Self {
        Self::Write(error)
    }
}

/// All other errors of the encoder are excluded before.
impl From<png::EncodingError> for FileError {
    fn from(error: png::EncodingError) -> Self {
        Self::Write(error.into())
    }
}

impl From<gif::EncodingError> for FileError {
    fn from(error: gif::EncodingError) -> Self {
        match error {
            gif::EncodingError::Io(error) => Self::Write(error),
            other => Self::Write(io::Error::other(other)),
        }
    }
}
