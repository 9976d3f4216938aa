//! The bounds of a picture.

use mech_runtime::{Canvas, Outline, Pose};

/// A canvas of infinite scale that paints nothing and keeps the box around all that is filled. What has a size in pixels has none on it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Bounds(Option<[[f64; 2]; 2]>);

impl Bounds {
    /// The lower left and the upper right corner, if anything is seen.
    pub(super) const fn corners(self) -> Option<[[f64; 2]; 2]> {
        self.0
    }

    /// Includes a box. One that is not finite is left out.
    fn include(&mut self, [low, high]: [[f64; 2]; 2]) {
        if [low, high].as_flattened().iter().all(|c| c.is_finite()) {
            let [lowest, highest] = self.0.unwrap_or([low, high]);
            self.0 = Some([
                [lowest[0].min(low[0]), lowest[1].min(low[1])],
                [highest[0].max(high[0]), highest[1].max(high[1])],
            ]);
        }
    }
}

impl Canvas<f64> for Bounds {
    fn fill(&mut self, outline: Outline<'_, f64>, pose: Pose<f64>, _: u8) {
        self.include(outline.bounds(pose).into());
    }

    fn text(&mut self, place: [f64; 2], _: &str, _: u8) {
        self.include([place; 2]);
    }

    fn scale(&self) -> f64 {
        f64::INFINITY
    }
}
