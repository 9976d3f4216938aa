//! SVG: pictures of any size, and pictures that move.

mod animated;
mod columns;
mod drawing;
mod element;
mod figure;
mod layers;
mod moving;
mod number;
mod place;
mod sheet;
mod trace;
mod track;

pub use animated::animate;
pub use drawing::Svg;
pub use moving::{AnimatedSvg, Moment};
pub use sheet::Sheet;
