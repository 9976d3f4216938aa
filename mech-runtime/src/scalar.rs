//! The two scalar types mechanisms are computed in.

use mech_core::Real;
use nalgebra::RealField;

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// `f32` or `f64`: what a mechanism computes in.
pub trait Scalar: RealField + Real + sealed::Sealed {
    /// 2⁴⁰ times the number, without what is behind the point; of what is too large, the largest; of what is not a number, zero.
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
            #[allow(
                clippy::cast_possible_truncation,
                reason = "cutting off is what is asked for"
            )]
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
