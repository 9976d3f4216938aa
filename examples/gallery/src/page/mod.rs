//! Pictures, films and the page.

mod animation;
mod curator;
mod diagram;
mod easel;
mod effects;
mod error;
mod exhibit;
mod film;
mod graph_layout;
mod graph_svg;
mod graphs;
mod html;
mod landmarks;
mod layers;
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
