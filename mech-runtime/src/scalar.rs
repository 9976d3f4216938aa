//! The two scalar types.

use core::fmt::Display;
use core::ops::{AddAssign, DivAssign, MulAssign, SubAssign};
use mech_core::Real;
use nalgebra::ComplexField;

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// The type of a mechanism's numbers: `f32` or `f64`.
///
/// [`Real`] has its functions. Code that needs more adds `nalgebra::RealField` as a bound of its own.
pub trait Scalar:
    Real
    + Display
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
    + Send
    + Sync
    + sealed::Sealed
    + 'static
{
    /// The lesser of two numbers. If one is NaN, the other.
    #[must_use]
    fn min(self, other: Self) -> Self;

    /// The greatest whole number that is not above this number.
    #[doc(hidden)]
    #[must_use]
    fn floor(self) -> Self;

    /// The same number.
    #[doc(hidden)]
    fn from_f32(value: f32) -> Self;

    /// 2⁴⁰ times the number, rounded towards zero. Too large a number saturates; NaN gives zero.
    #[doc(hidden)]
    fn to_fixed(self) -> i64;

    /// The nearest `f32`.
    #[doc(hidden)]
    fn to_f32(self) -> f32;
}

macro_rules! scalar {
    ($float:ident) => {
        impl Scalar for $float {
            #[inline]
            fn min(self, other: Self) -> Self {
                $float::min(self, other)
            }

            #[inline]
            fn floor(self) -> Self {
                ComplexField::floor(self)
            }

            #[inline]
            #[allow(clippy::useless_conversion, reason = "of an `f32` it is itself")]
            fn from_f32(value: f32) -> Self {
                Self::from(value)
            }

            #[inline]
            #[allow(clippy::cast_possible_truncation, reason = "cutting off is what is asked for")]
            fn to_fixed(self) -> i64 {
                const ONE: $float = 1_099_511_627_776.0;
                (self * ONE) as i64
            }

            #[inline]
            #[allow(
                clippy::cast_possible_truncation,
                clippy::unnecessary_cast,
                reason = "rounding is what is asked for"
            )]
            fn to_f32(self) -> f32 {
                self as f32
            }
        }
    };
}

scalar!(f32);
scalar!(f64);
