//! Pictures as files, with feature `std`: PNG, animated GIF, animated PNG, SVG and animated SVG.
//!
//! | kind | source | function |
//! |---|---|---|
//! | PNG | a [`Frame`](crate::Frame), a [`Smooth`](crate::Smooth), their kinds on the heap, any [`Picture`] | [`Frame::png`](crate::Frame::png), [`Smooth::png`](crate::Smooth::png), [`Picture::write_png`] |
//! | animated GIF | frames with a palette | [`Gif`] |
//! | animated PNG | frames with a palette, or pictures in true colour | [`Apng`] |
//! | SVG | anything that draws on a [`Canvas`](crate::Canvas) | [`Svg`] |
//! | animated SVG | one period of a mechanism, or anything that draws moment by moment | [`animate`], [`AnimatedSvg`] |
//!
//! Pixels are written to any [`io::Write`](std::io::Write). [`FileError`] is the error. An SVG is text.

mod apng;
mod clock;
mod error;
mod gif;
mod patch;
mod picture;
mod still;
mod svg;
mod table;

pub use apng::Apng;
pub use error::FileError;
pub use gif::Gif;
pub use picture::Picture;
pub use svg::{AnimatedSvg, Sheet, Svg, animate};
