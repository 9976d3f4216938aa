//! Why a file could not be made.

use core::fmt;
use std::io;

/// A picture could not be made into a file.
#[derive(Debug)]
#[non_exhaustive]
pub enum FileError {
    /// The picture is 0 pixels wide or high.
    Empty,
    /// There are not as many pixels as the size says.
    Torn {
        /// How many there should be: the width times the height.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// The picture is wider or higher than this kind of file can say.
    TooLarge {
        /// The most pixels in one direction.
        most: usize,
    },
    /// A frame of an animation has another size than the first one.
    OtherSize {
        /// The width and height of the first.
        expected: [usize; 2],
        /// Its own.
        found: [usize; 2],
    },
    /// A GIF was given a picture in true colour: it holds pictures with a palette only.
    TrueColor,
    /// An animated PNG was given a picture with a palette after one in true colour, or the other way round.
    OtherKind,
    /// A frame of an animated PNG has a colour that the palette of the first one lacks.
    OtherColor([u8; 3]),
    /// A frame of an animation is to be seen for longer than this kind of file can say: 655 seconds in a GIF, 65 in an animated PNG.
    TooLong,
    /// The number of frames is not the one that was announced.
    OtherCount {
        /// The number announced.
        announced: u32,
        /// How many there were; one more than announced, if another was to be added.
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
                write!(
                    f,
                    "there are {found} pixels, where its size takes {expected}"
                )
            }
            Self::TooLarge { most } => {
                write!(f, "the picture is more than {most} pixels wide or high")
            }
            Self::OtherSize {
                expected: [width, height],
                found,
            } => write!(
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

/// Everything else that encoders complain of was looked at before.
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
