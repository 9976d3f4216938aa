//! Pictures: pixels of a palette or in true colour, filled row by row.
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
//! A pixel belongs to a shape if its centre does. A centre exactly on an outline belongs to the shape on its right, or below it. So shapes
//! that share an edge leave no gap and paint no pixel twice. An outline with a number that is not finite is not painted.
//!
//! # Memory
//!
//! | size fixed at compile time | size chosen at run time, on the heap | bytes per pixel | other memory |
//! |---|---|---|---|
//! | [`Frame`] | `HeapFrame` | 1 | 0.8 KiB |
//! | [`Smooth`] | `HeapSmooth` | 4 | 16 rows, and 2 KiB |
//! | [`Stage`] | `HeapStage` | 2 | 2 KiB, and 40 bytes for each outline |
//!
//! A picture of fixed size in a local variable lies on the stack. A large one overflows it, and no program can catch that. 1024 × 768 pixels of
//! a `Smooth` take 3.2 MB, and a thread has 2 MiB by default. It can lie in a static. Pictures on the heap need feature `std` and 3 KiB of
//! stack. `TooLarge` is the error of a picture that exceeds the memory.
//!
//! With feature `embedded-graphics`, `raster::embedded` brings pictures to displays.

mod arc;
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
mod memory;
mod paint;
mod palette;
mod picture;
mod polygon;
mod smooth;
mod spans;
mod stage;
mod stroke;
mod tour;
mod turn;
mod view;

#[cfg(feature = "std")]
pub use frame::HeapFrame;
pub use frame::{Frame, Indexed};
pub use line::{bar, line};
#[cfg(feature = "std")]
pub(crate) use memory::Grid;
pub use memory::{Array, Memory};
#[cfg(feature = "std")]
pub use memory::{Heap, TooLarge};
pub use palette::Palette;
#[cfg(feature = "std")]
pub use smooth::HeapSmooth;
pub use smooth::{Smooth, Soft};
#[cfg(feature = "std")]
pub use stage::HeapStage;
pub use stage::{Area, Pass, Stage, Staged};
pub use view::View;

use crate::{Outline, Pose, Scalar};

/// A surface on which shapes are painted.
pub trait Canvas<T: Scalar> {
    /// Fills an outline in the frame of a link at `pose` with entry `color` of the palette. An outline that is not finite is not painted.
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8);

    /// Writes an upright text with entry `color` of the palette. Its lower left corner is at a place in the scene.
    ///
    /// At any scale, letters are five pixels wide and seven high, one every six pixels. The font has printable ASCII and
    /// `° ± ² · × − Δ α β γ δ θ λ μ π φ ψ ω`. Any other character is a box.
    fn text(&mut self, place: [T; 2], text: &str, color: u8);

    /// Draws a part of a trace: a line of this width through places in the scene where a point has been. What shows a whole motion shows the
    /// whole path of the point.
    fn trace(&mut self, places: &[[T; 2]], width: T, color: u8) {
        let points = places;
        self.fill(Outline::Line { points, width }, Pose::identity(), color);
    }

    /// The number of pixels per scene unit, for whatever has a size in pixels. On a canvas with infinite scale these have no size.
    fn scale(&self) -> T;
}
