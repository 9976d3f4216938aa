//! How long frames are seen.

use super::FileError;
use std::time::Duration;

/// Tells for each frame how many of the file's units of time it is seen, such that the moments are right that come out, however
/// coarse the units are.
#[derive(Debug)]
pub(super) struct Clock {
    delay: Duration,
    unit: Duration,
    frames: u32,
}

impl Clock {
    /// For frames that are all seen as long.
    pub(super) fn new(delay: Duration, unit: Duration) -> Result<Self, FileError> {
        if delay.as_nanos() / unit.as_nanos().max(1) >= u128::from(u16::MAX) {
            return Err(FileError::TooLong);
        }
        Ok(Self {
            delay,
            unit,
            frames: 0,
        })
    }

    /// For how many units the next frame is seen.
    pub(super) fn next(&mut self) -> u16 {
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
