//! Why a mechanism did not go where it was told.

use core::fmt;

/// A mechanism could not be moved as told; it is where it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Blocked<M = [f64; 1]> {
    /// The motor, the param or the loop at which it stopped: the name of the motor's joint or of the param, or the loop's joints of
    /// unknown coordinate.
    pub place: &'static str,
    /// What stopped it.
    pub cause: Cause,
    /// The values of the motors up to which it could have gone on the straight way to those it was told, in radians or scene
    /// units. [`move_toward`](crate::Mechanism::move_toward) goes there. Of a param that could not be set, the value up to which it
    /// could have been changed.
    pub reached: M,
}

/// What stopped a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Cause {
    /// The value or rate given to this motor or param is not a finite number.
    NotFinite,
    /// This loop does not close beyond the motor values reached: there is a dead point, or, where a fixed number of Newton
    /// steps was chosen, the step is too long for it.
    Open,
    /// This loop, solved by iteration, would have to pass a dead point or a change point to get there.
    DeadPoint,
    /// This loop is at a change point, and it was declared to stop there.
    ChangePoint,
    /// The way is too long to be followed past all its change points and dead points in one move.
    TooFar,
    /// The value given to this motor is outside its declared range.
    OutOfRange,
    /// There is no room left in the columns.
    NoRoom,
    /// A coordinate would be beyond the range of the scalar type, or a cam's law has no value there.
    Overflow,
    /// This loop is at a dead point or a change point, where rates are not determined by those of the motors.
    Singular,
    /// No mass resists this motor where it is, so forces do not tell how it moves.
    Massless,
    /// The step of time is so long that its iteration does not settle.
    StepTooLong,
}

/// How far a mechanism came that was moved as far as it goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[must_use]
pub enum Reached<M = [f64; 1]> {
    /// It is where it was told to go.
    Target,
    /// It is at its limit, at the motor values [`Blocked::reached`].
    Limit(Blocked<M>),
}

impl<M> Blocked<M> {
    /// The same with the motors' values in another form.
    #[must_use]
    pub fn map<N>(self, form: impl FnOnce(M) -> N) -> Blocked<N> {
        Blocked::new(self.place, self.cause, form(self.reached))
    }

    #[doc(hidden)]
    #[must_use]
    pub const fn new(place: &'static str, cause: Cause, reached: M) -> Self {
        Self {
            place,
            cause,
            reached,
        }
    }
}

impl<M: fmt::Debug> fmt::Display for Blocked<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (place, reached) = (self.place, &self.reached);
        match self.cause {
            Cause::NotFinite => write!(f, "the value for `{place}` is not a finite number"),
            Cause::Open => write!(f, "the loop {place} does not close beyond {reached:?}"),
            Cause::DeadPoint => write!(
                f,
                "the loop {place} would have to pass a dead point at {reached:?}"
            ),
            Cause::ChangePoint => write!(
                f,
                "the loop {place} is at a change point at {reached:?} and stops there as declared"
            ),
            Cause::TooFar => write!(f, "the way is too long to be followed in one move"),
            Cause::OutOfRange => write!(f, "the value for motor `{place}` is outside its range"),
            Cause::NoRoom => write!(f, "there is no room left in the columns"),
            Cause::Overflow => write!(f, "a coordinate would be beyond the range of the numbers"),
            Cause::Massless => write!(f, "no mass resists motor `{place}` at {reached:?}"),
            Cause::StepTooLong => write!(f, "the step of time is too long to be followed"),
            Cause::Singular => write!(
                f,
                "the rates of the loop {place} are not determined at {reached:?}: it is at a dead point or a change point"
            ),
        }
    }
}

impl<M: fmt::Debug> core::error::Error for Blocked<M> {}
