//! Pictures, films and the page.

mod animation;
mod curator;
mod easel;
mod error;
mod exhibit;
mod film;
mod graph_layout;
mod graph_svg;
mod graphs;
mod html;
mod strips;

pub use animation::{Swatches, animation};
pub use curator::Curator;
pub use easel::Easel;
pub use error::Error;
pub use exhibit::{Exhibit, FRAMES, Move, Showcase};
pub use film::{Film, Scene, Stuck};
pub use graphs::Graphs;
pub use strips::Picture;

/// A text as text of HTML or SVG.
fn escape(text: &str) -> String {
    let mut escape = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escape += "&amp;",
            '<' => escape += "&lt;",
            '>' => escape += "&gt;",
            '"' => escape += "&quot;",
            other => escape.push(other),
        }
    }
    escape
}
