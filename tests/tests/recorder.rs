//! What is painted, as it is asked of a canvas.

use mech_runtime::{Canvas, Outline, Pose, Scalar};

/// Gives what fills something to a function, and says that a unit of the scene is so many pixels.
pub(crate) struct Recorder<F> {
    pub(crate) scale: f64,
    pub(crate) fill: F,
}

impl<T: Scalar, F: FnMut(Outline<'_, T>, Pose<T>, u8)> Canvas<T> for Recorder<F> {
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8) {
        (self.fill)(outline, pose, color);
    }

    fn text(&mut self, _: [T; 2], _: &str, _: u8) {}

    fn scale(&self) -> T {
        T::from_f64(self.scale)
    }
}
