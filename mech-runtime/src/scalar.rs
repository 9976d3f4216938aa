//! The two scalar types mechanisms are computed in.

use nalgebra::RealField;

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// `f32` or `f64`: what a mechanism computes in.
pub trait Scalar: RealField + Copy + sealed::Sealed {
    /// The nearest `f64`, which for both types is the number itself.
    fn to_f64(self) -> f64;
    /// The nearest number of this type.
    fn from_f64(value: f64) -> Self;
    #[doc(hidden)]
    fn libm_sin_cos(self) -> (Self, Self);
    #[doc(hidden)]
    #[must_use]
    fn libm_atan2(self, x: Self) -> Self;
    #[doc(hidden)]
    #[must_use]
    fn libm_round(self) -> Self;
}

impl Scalar for f32 {
    fn to_f64(self) -> f64 {
        f64::from(self)
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "rounding is what is asked for"
    )]
    fn from_f64(value: f64) -> Self {
        value as Self
    }

    fn libm_sin_cos(self) -> (Self, Self) {
        libm::sincosf(self)
    }

    fn libm_atan2(self, x: Self) -> Self {
        libm::atan2f(self, x)
    }

    fn libm_round(self) -> Self {
        libm::roundf(self)
    }
}

impl Scalar for f64 {
    fn to_f64(self) -> f64 {
        self
    }

    fn from_f64(value: f64) -> Self {
        value
    }

    fn libm_sin_cos(self) -> (Self, Self) {
        libm::sincos(self)
    }

    fn libm_atan2(self, x: Self) -> Self {
        libm::atan2(self, x)
    }

    fn libm_round(self) -> Self {
        libm::round(self)
    }
}
