//! SVG: pictures of any size, and pictures that move.

mod animated;
mod drawing;
mod element;
mod layers;
mod moving;
mod number;
mod place;
mod sheet;
mod track;

pub use animated::animate;
pub use drawing::Svg;
pub use moving::AnimatedSvg;
pub use sheet::Sheet;
