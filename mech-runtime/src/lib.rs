//! **If it compiles, it moves.** Planar mechanisms, declared in Rust source, analysed at compile time, solved loop by
//! loop in straight-line `no_std` code.
#![no_std]

// The derive-like macro of this crate is called by path from the code it generates, here in our own tests too.
extern crate self as mech_runtime;

mod blocked;
#[doc(hidden)]
pub mod generated;
mod mechanism;
mod pose;
pub mod raster;
mod scalar;
mod shape;

pub use blocked::{Blocked, Cause};
pub use mechanism::Mechanism;
pub use nalgebra::{Isometry2, Point2};
pub use pose::Pose;
pub use raster::{Canvas, Frame, Palette, View};
pub use scalar::Scalar;
pub use shape::{Outline, Shape};

#[doc(hidden)]
pub use mech_macros::mechanism as expand_mechanism;

/// Declares a planar mechanism: a struct that moves, and a compile error if it would not.
///
/// The language is described in the crate's documentation.
#[macro_export]
macro_rules! mechanism {
    ($($body:tt)*) => {
        $crate::expand_mechanism! { $crate; $($body)* }
    };
}
