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

use std::time::Duration;

/// Counts the units of time for which each frame is shown. Frames begin at the right moments, to half a unit.
#[derive(Debug)]
struct Clock {
    delay: Duration,
    unit: Duration,
    frames: u32,
}

impl Clock {
    /// A clock for frames that are all shown for the same time.
    fn new(delay: Duration, unit: Duration) -> Result<Self, FileError> {
        if delay.as_nanos() / unit.as_nanos().max(1) >= u128::from(u16::MAX) {
            return Err(FileError::TooLong);
        }
        Ok(Self { delay, unit, frames: 0 })
    }

    /// The number of units for which the next frame is shown.
    fn next(&mut self) -> u16 {
        let units = self.units_until(self.frames + 1) - self.units_until(self.frames);
        // Long before it overflows, both are round and the film starts again.
        self.frames = (self.frames + 1) % (u32::MAX - 1);
        u16::try_from(units).unwrap_or(u16::MAX)
    }

    /// The moment of a frame, to the nearest unit.
    fn units_until(&self, frames: u32) -> u128 {
        let unit = self.unit.as_nanos().max(1);
        (self.delay.as_nanos() * u128::from(frames) + unit / 2) / unit
    }
}
