//! Errors of moves.

use crate::Scalar;
use core::fmt;

/// The error of a move that failed. The mechanism is where it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Blocked<M = [f64; 1]> {
    /// The motor, param or loop that stopped it: the name of the motor's joint or of the param, or the loop's joints of unknown
    /// coordinate.
    pub place: &'static str,
    /// The cause.
    pub cause: Cause,
    /// The motor values that the straight move could have reached, in radians or scene units.
    /// [`move_toward`](crate::Mechanism::move_toward) moves there. For a param that could not be set: the value it could have reached.
    pub reached: M,
    /// The inputs to which the numbers reached belong, for messages. Empty if unknown.
    pub(crate) inputs: &'static [Input],
}

/// The place at which a mechanism was stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// At the motor of this joint.
    Motor(&'static str),
    /// At this param.
    Param(&'static str),
    /// In the loop with these joints of unknown coordinate, each between `` ` ``.
    Loop(&'static str),
    /// At another argument: a load of this name, or the `time`.
    Given(&'static str),
    /// At no particular place.
    Everywhere,
}

/// An argument of a move.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// The value of a motor that turns, in radians.
    Turning(&'static str),
    /// The value of a motor that slides, in scene units.
    Sliding(&'static str),
    /// The value of a param.
    Param(&'static str),
}

impl Input {
    /// The name of the motor's joint or of the param.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Turning(name) | Self::Sliding(name) | Self::Param(name) => name,
        }
    }
}

/// The cause of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Cause {
    /// The value or rate given to this motor or param is not a finite number.
    NotFinite,
    /// This loop does not close beyond the motor values reached. It is at a dead point, or the step is too long for the chosen number
    /// of Newton's iterations.
    Open,
    /// This loop, solved by iteration, would have to pass a dead point or a change point.
    DeadPoint,
    /// This loop is at a change point, and the declaration says `stop`.
    ChangePoint,
    /// The move is too long to be followed past all its change points and dead points at once.
    TooFar,
    /// The value given to this motor is outside its declared range.
    OutOfRange,
    /// The columns are full.
    NoRoom,
    /// A coordinate would exceed the range of the scalar type, or a cam's law has no value.
    Overflow,
    /// This loop is at a dead point or a change point, where the motors' rates do not determine its own.
    Singular,
    /// No mass resists this motor, so forces do not determine its acceleration.
    Massless,
    /// The step of time is so long that its iteration does not converge.
    StepTooLong,
    /// Nothing pulls at the motors that are let go.
    Unloaded,
    /// Nothing stops what pulls at this motor, so it does not come to rest.
    Restless,
}

/// The end of a move that goes as far as it can.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[must_use]
pub enum Reached<M = [f64; 1]> {
    /// The mechanism is at its target.
    Target,
    /// The mechanism is at its limit, at the motor values [`Blocked::reached`].
    Limit(Blocked<M>),
}

impl<M> Blocked<M> {
    /// Converts the motors' values to another form, in the same order.
    #[must_use]
    pub fn map<N>(self, form: impl FnOnce(M) -> N) -> Blocked<N> {
        Blocked {
            place: self.place,
            cause: self.cause,
            reached: form(self.reached),
            inputs: self.inputs,
        }
    }

    /// The place at which it stopped: a motor, a param, a loop.
    #[must_use]
    pub fn at(&self) -> Place {
        let named = |input: &&Input| input.name() == self.place;
        match (self.inputs.iter().find(named), self.cause) {
            (Some(Input::Param(name)), _) => Place::Param(name),
            (Some(input), _) => Place::Motor(input.name()),
            (None, _) if self.place.is_empty() => Place::Everywhere,
            (None, Cause::NotFinite) => Place::Given(self.place),
            (None, Cause::OutOfRange | Cause::Massless | Cause::Overflow | Cause::Restless) => {
                Place::Motor(self.place)
            }
            (None, _) => Place::Loop(self.place),
        }
    }

    #[doc(hidden)]
    #[must_use]
    pub const fn new(place: &'static str, cause: Cause, reached: M) -> Self {
        Self { place, cause, reached, inputs: &[] }
    }

    /// Adds the inputs to which the numbers reached belong.
    #[doc(hidden)]
    #[must_use]
    pub const fn of(mut self, inputs: &'static [Input]) -> Self {
        self.inputs = inputs;
        self
    }

    /// Keeps the inputs from this one on.
    #[doc(hidden)]
    #[must_use]
    pub fn starting_at(mut self, first: usize) -> Self {
        self.inputs = self.inputs.get(first..).unwrap_or_default();
        self
    }
}

mod sealed {
    pub trait Sealed {}
    impl<T: crate::Scalar, const N: usize> Sealed for [T; N] {}
    #[cfg(feature = "std")]
    impl<T: crate::Scalar> Sealed for std::vec::Vec<T> {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// Numbers in a [`Blocked`] that can be printed: an array, a `Vec`, or a single number.
pub trait Values: sealed::Sealed {
    /// The type of each number: `f32` or `f64`.
    type Number: Scalar;

    /// The numbers, in the order of the motors or params.
    fn numbers(&self) -> &[Self::Number];
}

impl<T: Scalar, const N: usize> Values for [T; N] {
    type Number = T;

    fn numbers(&self) -> &[T] {
        self
    }
}

#[cfg(feature = "std")]
impl<T: Scalar> Values for std::vec::Vec<T> {
    type Number = T;

    fn numbers(&self) -> &[T] {
        self
    }
}

macro_rules! single {
    ($($float:ident)*) => {
        $(
            impl Values for $float {
                type Number = Self;

                fn numbers(&self) -> &[Self] {
                    core::slice::from_ref(self)
                }
            }
        )*
    };
}

single!(f32 f64);

/// Numbers with their names: angles in radians and in degrees, rounded to a thousandth.
struct NamedNumbers<'a, T> {
    numbers: &'a [T],
    inputs: &'static [Input],
}

impl<T: Scalar> fmt::Display for NamedNumbers<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.inputs.len() < self.numbers.len() {
            return write!(f, "{:?}", self.numbers);
        }
        for (index, (number, input)) in self.numbers.iter().zip(self.inputs).enumerate() {
            let separator = if index > 0 { ", " } else { "" };
            match input {
                Input::Turning(name) => {
                    let thousand = T::from_f64(1000.0);
                    let degrees = *number * (T::from_f64(360.0) / T::TURN);
                    let rounded = (degrees * thousand).round() / thousand;
                    write!(f, "{separator}{name} = {number:?} rad ({rounded:?}°)")?;
                }
                Input::Sliding(name) | Input::Param(name) => {
                    write!(f, "{separator}{name} = {number:?}")?;
                }
            }
        }
        Ok(())
    }
}

impl<M: Values> fmt::Display for Blocked<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = self.place;
        let reached = NamedNumbers { numbers: self.reached.numbers(), inputs: self.inputs };
        match self.cause {
            Cause::NotFinite => write!(f, "the value for `{place}` is not a finite number"),
            Cause::Open => write!(f, "the loop {place} does not close beyond {reached}"),
            Cause::DeadPoint => {
                write!(f, "the loop {place} would have to pass a dead point at {reached}")
            }
            Cause::ChangePoint => write!(
                f,
                "the loop {place} is at a change point at {reached} and stops there as declared"
            ),
            Cause::TooFar => write!(f, "the way is too long to be followed in one move"),
            Cause::OutOfRange => write!(
                f,
                "the value for `{place}` is outside its range; it goes as far as {reached}"
            ),
            Cause::NoRoom => write!(f, "there is no room left in the columns"),
            Cause::Overflow => write!(f, "a coordinate would be beyond the range of the numbers"),
            Cause::Massless => write!(f, "no mass resists motor `{place}` at {reached}"),
            Cause::StepTooLong => write!(f, "the step of time is too long to be followed"),
            Cause::Unloaded => {
                write!(f, "nothing pulls at the motors that are let go at {reached}")
            }
            Cause::Restless => {
                write!(f, "motor `{place}` does not come to rest: nothing stops what pulls at it")
            }
            Cause::Singular => write!(
                f,
                "the rates of the loop {place} are not determined at {reached}: it is at a dead point or a change point"
            ),
        }
    }
}

impl<M: Values + fmt::Debug> core::error::Error for Blocked<M> {}
