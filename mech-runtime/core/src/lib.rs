//! The base of generated code, its compiler and the studio: numerics that compute the same bits in all of them, symbols and outlines.
//!
//! [`trig`] has the sine and cosine of an angle in radians, in portable code that compilers can vectorise. [`Phase`] is an angle that a
//! motor may turn through for years without losing a bit. [`Symbol`] and [`Outline`] are what is drawn, over any numbers.
//!
//! The crate is `no_std`, needs no allocator, has no `unsafe` code and never panics. Its results are the same bits on every machine with
//! floats of IEEE 754: no operation is fused, and none depends on the processor's features.
#![no_std]

#[cfg(feature = "std")]
extern crate std;

pub mod colors;
pub mod contraction;
mod cost;
pub mod dense;
pub mod font;
mod joint;
pub mod journey;
mod kernel;
pub mod limit;
mod motion_law;
pub mod motors;
mod outline;
mod phase;
pub mod pieces;
mod pose;
mod power;
mod real;
mod reduction;
pub mod rest;
pub mod root;
pub mod surplus;
mod symbol;
pub mod trig;
mod turns;
pub mod wheel;

pub use cost::Cost;
pub use joint::{Coordinate, JointKind};
pub use motion_law::{MotionLaw, Staircase};
pub use outline::{Outline, Shape};
pub use phase::Phase;
pub use pose::Pose;
pub use real::Real;
pub use symbol::{Spot, Symbol};
