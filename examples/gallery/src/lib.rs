//! A gallery of mechanisms, each a `mechanism!` and a motion.
//!
//! The mechanisms are for any machine. Each module declares one, in `f64`; its submodule `single` has the same in `f32`. A motion is
//! the same bits everywhere, so that what another machine makes of it can be compared with what this one does.
//!
//! With the feature `page`, which is a default and needs the standard library, the runtime's own rasteriser paints them into pictures,
//! animations and a page. An [`Exhibit`] becomes a [`Film`], scene by scene; an [`Easel`] paints each [`Scene`] as an anti-aliased
//! [`Picture`]; the [`Curator`] hangs them all. A [`Playable`] is the same mechanism for whoever wants to move it himself.
#![cfg_attr(not(feature = "page"), no_std)]

#[cfg(feature = "page")]
mod exhibits;
mod mechanisms;
#[cfg(feature = "page")]
mod page;

#[cfg(feature = "page")]
pub use exhibits::exhibits;
pub use mechanisms::{
    Exhibited, Visitor, andrews, crane, diagram, four_bar, geared_piston, jansen, rocker_arm,
    velocities, visit_f32, visit_f64, watt,
};
#[cfg(feature = "page")]
pub use page::{
    Curator, Diagram, Easel, Effects, Error, Exhibit, FRAMES, Film, Graphs, Landmarks, Layer,
    Layers, Look, Move, MoveWith, Picture, Playable, Rates, Scene, Showcase, Spot, Strips, Stuck,
    Swatches, animation,
};
