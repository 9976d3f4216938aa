//! What a newcomer runs: a gallery of mechanisms, each a `mechanism!` and a motion, painted
//! by the runtime's own rasteriser into pictures, animations and a page.
//!
//! An [`Exhibit`] becomes a [`Film`], scene by scene; an [`Easel`] paints each [`Scene`] as an anti-aliased
//! [`Picture`]; the [`Curator`] hangs them all. A [`Playable`] is the same mechanism for whoever wants to move it himself.

mod animation;
mod curator;
mod diagram;
mod easel;
mod effects;
mod error;
mod exhibit;
mod film;
pub mod gallery;
mod graph_layout;
mod graph_svg;
mod graphs;
mod landmarks;
mod layers;
mod page;
mod picture;
mod playable;
mod played;
mod strips;
mod swatches;

pub use animation::animation;
pub use curator::Curator;
pub use diagram::{Diagram, Move};
pub use easel::Easel;
pub use effects::{Effects, MoveWith};
pub use error::Error;
pub use exhibit::{Exhibit, FRAMES, Showcase};
pub use film::{Film, Scene, Stuck};
pub use graphs::Graphs;
pub use landmarks::{Landmarks, Spot};
pub use layers::{Layer, Layers};
pub use picture::Picture;
pub use playable::{Look, Playable, Rates};
pub use strips::Strips;
pub use swatches::Swatches;
