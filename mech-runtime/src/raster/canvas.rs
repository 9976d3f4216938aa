//! The trait of everything that can be painted on.

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
