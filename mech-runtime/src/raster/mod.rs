//! The picture.

use crate::{Outline, Pose, Scalar};

/// Something that shapes can be painted on.
pub trait Canvas<T: Scalar> {
    /// Fills an outline given in the frame of a link that is at `pose`, with entry `color` of the palette.
    fn fill(&mut self, outline: Outline<T>, pose: Pose<T>, color: u8);
}
/// TODO
pub struct Frame;
/// TODO
pub struct Palette;
/// TODO
pub struct View;
