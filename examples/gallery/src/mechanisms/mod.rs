//! The mechanisms and how they move: without the standard library and without allocation.

mod precisions;
mod visitor;

pub mod andrews;
pub mod antikythera;
pub mod crane;
pub mod diagram;
pub mod excavator;
pub mod four_bar;
pub mod geared_piston;
pub mod jansen;
pub mod rocker_arm;
pub mod skeleton;
pub mod velocities;
pub mod walker;
pub mod watt;

pub use precisions::Exhibited;
pub use visitor::{Visitor, visit_f32, visit_f64};
