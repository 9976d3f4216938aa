//! The mechanisms of the gallery and how they move, for any machine: `no_std`, without allocation.
//!
//! Each module declares one mechanism, in `f64`; its submodule `single` has the same in `f32`. A motion is the same bits
//! everywhere, so that what another machine makes of it can be compared with what this one does.
#![no_std]

mod exhibited;
mod precisions;
mod visitor;

pub mod andrews;
pub mod crane;
pub mod diagram;
pub mod four_bar;
pub mod geared_piston;
pub mod jansen;
pub mod rocker_arm;
pub mod velocities;
pub mod watt;

pub use exhibited::Exhibited;
pub use visitor::{Visitor, visit_f32, visit_f64};
