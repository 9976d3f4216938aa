//! What a newcomer runs: a gallery of mechanisms, each a `mechanism!` and a motion, painted
//! by the runtime's own rasteriser into pictures, animations and a page.
//!
//! An [`Exhibit`] becomes a [`Film`], scene by scene; an [`Easel`] paints each [`Scene`] as an anti-aliased
//! [`Picture`]; the [`Curator`] hangs them all.

mod animation;
mod curator;
mod diagram;
mod easel;
mod error;
mod exhibit;
mod film;
pub mod gallery;
mod graph_layout;
mod graph_svg;
mod graphs;
mod page;
mod picture;
mod swatches;

pub use animation::animation;
pub use curator::Curator;
pub use diagram::{Diagram, Move};
pub use easel::Easel;
pub use error::Error;
pub use exhibit::{Exhibit, FRAMES, Showcase};
pub use film::{Film, Scene, Stuck};
pub use graphs::Graphs;
pub use picture::Picture;
pub use swatches::Swatches;
