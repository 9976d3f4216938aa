//! The picture: one byte a pixel and a table of false colours, filled by scanline spans.
//!
//! ```
//! use mech_runtime::{Canvas, Frame, Outline, Palette, Pose, View};
//!
//! static TRIANGLE: [[f32; 2]; 3] = [[0.0, 0.0], [3.0, 0.0], [0.0, 3.0]];
//!
//! let mut frame = Frame::<64, 48>::new();
//! frame.look_at(View::fit([-1.0, -1.0], [4.0, 4.0], 64, 48, 2.0));
//! frame.fill(Outline::Polygon(&TRIANGLE), Pose::identity(), Palette::BLUE);
//! assert_eq!(frame.pixel(26, 26), Some(Palette::BLUE));
//! ```
//!
//! A pixel belongs to a shape if its centre does. A centre exactly on an outline belongs to the shape on its right, or
//! below it: so shapes that share an edge leave no gap between them and paint no pixel twice. Whatever is not finite is
//! not painted.
//!
//! With feature `embedded-graphics`, `raster::embedded` brings pictures to displays.

mod arc;
mod canvas;
mod chain;
mod circle;
mod crossings;
mod edge;
#[cfg(feature = "embedded-graphics")]
pub mod embedded;
mod fixed;
mod font;
mod frame;
mod line;
mod paint;
mod palette;
mod polygon;
mod smooth;
mod spans;
mod stage;
mod stroke;
mod tour;
mod turn;
mod view;

pub use canvas::Canvas;
pub use frame::Frame;
pub use line::{bar, line};
pub use palette::Palette;
pub use smooth::Smooth;
pub use stage::{Area, Pass, Stage};
pub use view::View;
