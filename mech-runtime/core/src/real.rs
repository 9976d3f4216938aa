//! The floats of mechanisms.

#[cfg(not(feature = "std"))]
use crate::root;
use crate::{Phase, trig, turns};
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A float in which a mechanism can be computed: `f32` or `f64`.
pub trait Real:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The distance from one to the next greater number.
    const EPSILON: f64;
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// One half.
    const HALF: Self;
    /// A whole turn, in radians.
    const TURN: Self;
    /// The nearest number of this type.
    fn from_f64(value: f64) -> Self;
    /// The nearest number of this type.
    fn from_i32(value: i32) -> Self;
    /// The nearest number of this type.
    fn from_i64(value: i64) -> Self;
    /// The nearest whole number of turns of a phase, and the remainder in radians.
    fn of_phase(phase: Phase) -> (i64, Self);
    /// The nearest whole number of turns of an angle in radians, and the remainder in radians. `None` beyond 2³¹ turns.
    fn whole_turns(self) -> Option<(i32, Self)>;
    /// The number itself.
    fn to_f64(self) -> f64;
    /// The number rounded towards zero. Outside of the range of `i32` it saturates; NaN gives zero.
    fn to_i32(self) -> i32;
    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// The greater of two numbers, or the second if one is NaN. One instruction on most machines.
    #[must_use]
    fn max(self, other: Self) -> Self;
    /// The absolute value with the sign of another number.
    #[must_use]
    fn copysign(self, sign: Self) -> Self;
    /// The sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// The angle of the vector (`x`, `self`), in radians.
    #[must_use]
    fn atan2(self, x: Self) -> Self;
    /// The exponential: e to this power.
    #[must_use]
    fn exp(self) -> Self;
    /// The nearest whole number, halves away from zero.
    #[must_use]
    fn round(self) -> Self;
    /// Whether it is neither infinite nor NaN.
    fn is_finite(self) -> bool;
}

macro_rules! real {
    ($float:ident, $sin_cos:ident, $sqrt:path, $atan2:ident, $exp:ident, $round:ident, $split:ident, $turns:ident) => {
        impl Real for $float {
            const EPSILON: f64 = $float::EPSILON as f64;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const HALF: Self = 0.5;
            const TURN: Self = core::$float::consts::TAU;

            #[inline]
            #[allow(clippy::cast_possible_truncation, reason = "rounding is intended")]
            fn from_f64(value: f64) -> Self {
                value as Self
            }

            #[inline]
            #[allow(
                clippy::cast_precision_loss,
                clippy::cast_lossless,
                reason = "rounding is intended, and exact where it can be"
            )]
            fn from_i32(value: i32) -> Self {
                value as Self
            }

            #[inline]
            #[allow(clippy::cast_precision_loss, reason = "rounding is intended")]
            fn from_i64(value: i64) -> Self {
                value as Self
            }

            #[inline]
            fn of_phase(phase: Phase) -> (i64, Self) {
                phase.$split()
            }

            #[inline]
            fn whole_turns(self) -> Option<(i32, Self)> {
                turns::$turns(self)
            }

            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            #[inline]
            #[allow(clippy::cast_possible_truncation, reason = "it saturates, and NaN gives zero")]
            fn to_i32(self) -> i32 {
                self as i32
            }

            #[inline]
            fn abs(self) -> Self {
                $float::abs(self)
            }

            // Both are rounded correctly, so both give the same bits. That of `std` can be vectorised.
            #[cfg(feature = "std")]
            #[inline]
            fn sqrt(self) -> Self {
                $float::sqrt(self)
            }

            #[cfg(not(feature = "std"))]
            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            #[inline]
            fn max(self, other: Self) -> Self {
                if self > other { self } else { other }
            }

            #[inline]
            fn copysign(self, sign: Self) -> Self {
                $float::copysign(self, sign)
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                trig::$sin_cos(self)
            }

            #[inline]
            fn atan2(self, x: Self) -> Self {
                libm::$atan2(self, x)
            }

            #[inline]
            fn exp(self) -> Self {
                libm::$exp(self)
            }

            #[inline]
            fn round(self) -> Self {
                libm::$round(self)
            }

            #[inline]
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }
        }
    };
}

real!(f32, sin_cos_f32, root::sqrt_f32, atan2f, expf, roundf, split_f32, whole_turns_f32);
real!(f64, sin_cos_f64, libm::sqrt, atan2, exp, round, split_f64, whole_turns_f64);
