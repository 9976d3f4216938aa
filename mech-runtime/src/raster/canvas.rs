//! What shapes are painted on.

use crate::{Outline, Pose, Scalar};

/// Something that shapes can be painted on.
pub trait Canvas<T: Scalar> {
    /// Fills an outline given in the frame of a link that is at `pose`, with entry `color` of the palette. What is not finite is not
    /// painted.
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8);

    /// Writes a text upright, with its lower left corner at a place in the scene, with entry `color` of the palette. Letters are
    /// five pixels wide and seven high, one every six pixels, however large the scene is seen. There is printable ASCII, and
    /// `° ± ² · × − Δ α β γ δ θ λ μ π φ ψ ω`; anything else is a box.
    fn text(&mut self, place: [T; 2], text: &str, color: u8);

    /// How many pixels a scene unit is: whatever has a size in pixels asks for it. Infinite for a canvas that only wants to
    /// know where things are: then they have no size.
    fn scale(&self) -> T;
}
