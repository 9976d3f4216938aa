//! The arithmetic of a program, the same in every reading of it.

use super::node::{Op, Value};
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A float in which a program can be run.
pub trait Real:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The distance from one to the next greater number.
    const EPSILON: f64;
    /// The nearest number of this type.
    fn from_f64(value: f64) -> Self;
    /// The number itself.
    fn to_f64(self) -> f64;
    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// The greater of two numbers; that which is a number, if only one is.
    #[must_use]
    fn max(self, other: Self) -> Self;
    /// Its size with the sign of another.
    #[must_use]
    fn copysign(self, sign: Self) -> Self;
    /// The angle of the vector (`x`, `self`).
    #[must_use]
    fn atan2(self, x: Self) -> Self;
    /// The nearest whole number, halves away from zero.
    #[must_use]
    fn round(self) -> Self;
    /// Whether it is neither infinite nor not a number.
    fn is_finite(self) -> bool;
}

macro_rules! real {
    ($float:ty, $sincos:ident, $atan2:ident, $round:ident) => {
        impl Real for $float {
            const EPSILON: f64 = <$float>::EPSILON as f64;

            #[allow(
                clippy::cast_possible_truncation,
                reason = "rounding is what is asked for"
            )]
            fn from_f64(value: f64) -> Self {
                value as Self
            }

            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            fn abs(self) -> Self {
                <$float>::abs(self)
            }

            fn sqrt(self) -> Self {
                <$float>::sqrt(self)
            }

            fn max(self, other: Self) -> Self {
                <$float>::max(self, other)
            }

            fn copysign(self, sign: Self) -> Self {
                <$float>::copysign(self, sign)
            }

            // The generated code calls the same library, so that both give the same bits.
            fn sin_cos(self) -> (Self, Self) {
                libm::$sincos(self)
            }

            fn atan2(self, x: Self) -> Self {
                libm::$atan2(self, x)
            }

            fn round(self) -> Self {
                libm::$round(self)
            }

            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }
        }
    };
}

real!(f32, sincosf, atan2f, roundf);
real!(f64, sincos, atan2, round);

impl Op {
    /// What the operation gives, if it is arithmetic on values; the others come from outside.
    pub fn apply<T: Real>(self, get: impl Fn(Value) -> T) -> Option<T> {
        Some(match self {
            Self::Constant(number) => T::from_f64(number.get()),
            Self::Motor(_)
            | Self::Last(_)
            | Self::Unknown(..)
            | Self::Solved(..)
            | Self::Dense(..) => {
                return None;
            }
            Self::Neg(a) => -get(a),
            Self::Abs(a) => get(a).abs(),
            Self::Sqrt(a) => get(a).sqrt(),
            Self::Add(a, b) => get(a) + get(b),
            Self::Sub(a, b) => get(a) - get(b),
            Self::Mul(a, b) => get(a) * get(b),
            Self::Div(a, b) => get(a) / get(b),
            Self::Sin(a) => get(a).sin_cos().0,
            Self::Cos(a) => get(a).sin_cos().1,
            Self::Max(a, b) => get(a).max(get(b)),
            Self::CopySign(a, b) => get(a).copysign(get(b)),
            Self::Atan2(a, b) => get(a).atan2(get(b)),
            Self::Round(a) => get(a).round(),
        })
    }
}
