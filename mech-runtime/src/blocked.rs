//! Why a mechanism did not go where it was told.

use core::fmt;

/// A mechanism could not be moved as told; it is where it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Blocked {
    /// The motor or the loop at which it stopped: the name of the motor's joint, or the loop's joints of unknown coordinate.
    pub place: &'static str,
    /// What stopped it.
    pub cause: Cause,
}

/// What stopped a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Cause {
    /// The value given to this motor is not a finite number.
    NotFinite,
    /// This loop does not close at the motor values given: they are out of reach, or too far from the last ones for the
    /// number of Newton steps chosen.
    Open,
    /// This loop would have to pass a dead point or a change point to get there.
    DeadPoint,
    /// A coordinate would be beyond the range of the scalar type.
    Overflow,
}

impl Blocked {
    #[doc(hidden)]
    #[must_use]
    pub const fn new(place: &'static str, cause: Cause) -> Self {
        Self { place, cause }
    }
}

impl fmt::Display for Blocked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = self.place;
        match self.cause {
            Cause::NotFinite => write!(f, "the value for motor `{place}` is not a finite number"),
            Cause::Open => write!(f, "the loop {place} does not close there"),
            Cause::DeadPoint => write!(
                f,
                "the loop {place} would have to pass a dead point to get there"
            ),
            Cause::Overflow => write!(f, "a coordinate would be beyond the range of the numbers"),
        }
    }
}

impl core::error::Error for Blocked {}
