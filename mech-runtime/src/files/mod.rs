//! Pictures as files, with feature `std`: PNG, animated GIF and PNG, SVG.
//!
//! | kind | of | by |
//! |---|---|---|
//! | PNG | a [`Frame`](crate::Frame) or [`Smooth`](crate::Smooth), also on the heap, or any [`Picture`] | [`Frame::png`](crate::Frame::png), [`Smooth::png`](crate::Smooth::png), [`Picture::write_png`] |
//! | animated GIF | frames with a palette | [`Gif`] |
//! | animated PNG | frames with a palette, or pictures in true colour | [`Apng`] |
//! | SVG | whatever draws on a [`Canvas`](crate::Canvas) | [`Svg`] |
//! | animated SVG | one period of a mechanism, or whatever draws moment by moment | [`animated`], [`AnimatedSvg`] |
//!
//! Pixels are written to any [`io::Write`](std::io::Write), and what goes wrong is a [`FileError`]; an SVG is text.

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
pub use svg::{AnimatedSvg, Moment, Sheet, Svg, animated};
