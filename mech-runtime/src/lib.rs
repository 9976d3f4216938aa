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
