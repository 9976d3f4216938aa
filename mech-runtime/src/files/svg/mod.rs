//! SVG: pictures that look well at any size, and such that move.

mod animated;
mod drawing;
mod figure;
mod layers;
mod moving;
mod number;
mod place;
mod sheet;
mod track;

pub use animated::animated;
pub use drawing::Svg;
pub use moving::{AnimatedSvg, Moment};
pub use sheet::Sheet;
