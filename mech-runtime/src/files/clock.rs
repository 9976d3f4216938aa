//! The times for which frames are shown.

use super::FileError;
use std::time::Duration;

/// Counts the units of time for which each frame is shown. Frames begin at the right moments, to half a unit.
#[derive(Debug)]
pub(super) struct Clock {
    delay: Duration,
    unit: Duration,
    frames: u32,
}

impl Clock {
    /// A clock for frames that are all shown for the same time.
    pub(super) fn new(delay: Duration, unit: Duration) -> Result<Self, FileError> {
        if delay.as_nanos() / unit.as_nanos().max(1) >= u128::from(u16::MAX) {
            return Err(FileError::TooLong);
        }
        Ok(Self { delay, unit, frames: 0 })
    }

    /// The number of units for which the next frame is shown.
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
