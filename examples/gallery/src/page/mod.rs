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
mod picture;
mod strips;
mod swatches;

pub use animation::animation;
pub use curator::Curator;
pub use easel::Easel;
pub use error::Error;
pub use exhibit::{Exhibit, FRAMES, Move, Showcase};
pub use film::{Film, Scene, Stuck};
pub use graphs::Graphs;
pub use picture::Picture;
pub use swatches::Swatches;

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
