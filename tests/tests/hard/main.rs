//! The hard cases, each by name, in both precisions and by every method that applies.
//!
//! What must come out is formula or plain geometry in double precision ([`geometry`]); that links keep their lengths and pins
//! their places is read off the declaration and the poses alone ([`bed`]).

#![allow(
    clippy::needless_pass_by_value,
    clippy::excessive_precision,
    reason = "a check has its bed to itself; digits stand as their source gives them"
)]

#[macro_use]
mod variants;

mod bed;
mod change_points;
mod coupled;
mod dead_points;
mod geometry;
mod keep_and_stop;
mod limits;
mod near_misses;
mod plain;
mod sizes;
mod sliders;
mod slides;
mod turns;
