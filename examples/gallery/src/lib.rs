//! A gallery of mechanisms, each a `mechanism!` and a motion.
//!
//! The mechanisms run on any machine. Each module declares one in `f64`, and its submodule `single` has it in `f32`. A motion has the same
//! bits everywhere, so the results of two machines can be compared.
//!
//! The default feature `page` needs the standard library. With it, the runtime paints pictures, animations and a page. An [`Exhibit`]
//! becomes a [`Film`], scene by scene. An [`Easel`] paints each [`Scene`] as an anti-aliased [`Picture`]. The [`Curator`] hangs them all.
#![cfg_attr(not(feature = "page"), no_std)]

#[cfg(feature = "page")]
mod exhibits;
mod mechanisms;
#[cfg(feature = "page")]
mod page;

#[cfg(feature = "page")]
pub use exhibits::exhibits;
pub use mechanisms::{
    Exhibited, Visitor, andrews, antikythera, crane, diagram, excavator, four_bar, geared_piston,
    jansen, rocker_arm, skeleton, velocities, visit_f32, visit_f64, walker, watt,
};
#[cfg(feature = "page")]
pub use page::{
    Curator, Easel, Error, Exhibit, FRAMES, Film, Graphs, Move, Picture, Scene, Showcase, Stuck,
    Swatches, animation,
};
