//! SVG: pictures that look well at any size, and such that move.

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

pub use animated::animated;
pub use drawing::Svg;
pub use moving::{AnimatedSvg, Moment};
pub use sheet::Sheet;
