//! The numerics that the code generated for a mechanism and the compiler's interpreter of it share, so that both give the
//! same bits.
//!
//! [`trig`] has the sine and cosine of an angle in radians, in portable code that a compiler can vectorise; [`Phase`] is an
//! angle that a motor may turn through for years without losing a bit.
//!
//! The crate is `no_std`, needs no allocator, has no `unsafe` code and never panics. Its results are the same bits on every
//! machine whose floats are those of IEEE 754: nothing is fused, nothing depends on the processor's features.
#![no_std]

#[cfg(feature = "std")]
extern crate std;

pub mod colors;
pub mod contraction;
pub mod dense;
pub mod journey;
mod kernel;
pub mod motors;
mod phase;
mod power;
mod real;
mod reduction;
pub mod root;
pub mod trig;
mod turns;

pub use phase::Phase;
pub use real::Real;
