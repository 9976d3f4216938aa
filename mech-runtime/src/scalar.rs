//! The two scalar types mechanisms are computed in.

use mech_core::Real;
use nalgebra::RealField;

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// `f32` or `f64`: what a mechanism computes in.
pub trait Scalar: RealField + Real + sealed::Sealed {}

impl Scalar for f32 {}
impl Scalar for f64 {}
