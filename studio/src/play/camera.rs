//! The camera: the part of the scene that is seen.

use mech_runtime::{Canvas, Outline, Pose, View};

/// Paper left free around a whole motion, as a part of the shorter side.
const MARGIN: f64 = 0.07;
/// The shorter side of a picture of usual size.
const USUAL: f64 = 560.0;
/// The greatest magnification and reduction, relative to the whole motion.
const MOST: f64 = 1e4;

/// Looks at a scene from in front. Its picture has a size in pixels, which count from the upper left corner.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// The box of the whole motion: lower left and upper right corner, in scene units.
    bounds: [[f64; 2]; 2],
    size: [usize; 2],
    view: View,
    /// Whether it shows the whole motion, as large as possible.
    fits: bool,
}

impl Camera {
    /// A camera that shows the box between these corners in a picture of this size.
    #[must_use]
    pub fn new(bounds: [[f64; 2]; 2], size: [usize; 2]) -> Self {
        let view = fit_motion(bounds, size);
        Self { bounds, size, view, fits: true }
    }

    /// Shows the whole motion again.
    pub fn fit(&mut self) {
        *self = Self::new(self.bounds, self.size);
    }

    /// Enlarges the box of the whole motion to include this one, if it shows the whole motion.
    pub(crate) fn include(&mut self, [low, high]: [[f64; 2]; 2]) {
        let [left, top] = self.pixel([low[0], high[1]]);
        let [right, bottom] = self.pixel([high[0], low[1]]);
        let [width, height] = self.extent();
        let is_seen = left >= 0.0 && top >= 0.0 && right <= width && bottom <= height;
        let is_box = [low, high].as_flattened().iter().all(|c| c.is_finite());
        if self.fits && is_box && !is_seen {
            let [lowest, highest] = self.bounds;
            self.bounds = [
                [lowest[0].min(low[0]), lowest[1].min(low[1])],
                [highest[0].max(high[0]), highest[1].max(high[1])],
            ];
            self.fit();
        }
    }

    /// Changes the size of the picture. A chosen centre stays.
    pub(crate) fn resize(&mut self, size: [usize; 2]) {
        self.size = size;
        if self.fits {
            self.fit();
        }
    }

    /// Magnifies by a factor. The place at `pixel` stays there.
    pub(crate) fn zoom(&mut self, pixel: [f64; 2], factor: f64) {
        let whole = fit_motion(self.bounds, self.size).scale();
        let scale = (self.view.scale() * factor).clamp(whole / MOST, whole * MOST);
        let [x, y] = self.place(pixel);
        if scale.is_finite() && x.is_finite() && y.is_finite() {
            let share = self.view.scale() / scale;
            let [u, v] = self.view.center();
            let center = [x + share * (u - x), y + share * (v - y)];
            self.view = View::new(center, scale);
            self.fits = false;
        }
    }

    /// Moves the picture by so many pixels.
    pub(crate) fn pan(&mut self, [right, down]: [f64; 2]) {
        let scale = self.view.scale();
        let [x, y] = self.view.center();
        let center = [x - right / scale, y + down / scale];
        if center.iter().all(|c| c.is_finite()) {
            self.view = View::new(center, scale);
            self.fits = false;
        }
    }

    /// The place in the scene at a pixel.
    #[must_use]
    pub fn place(&self, pixel: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.view.center();
        let [width, height] = self.extent();
        let scale = self.view.scale();
        [x + (pixel[0] - width / 2.0) / scale, y - (pixel[1] - height / 2.0) / scale]
    }

    /// The pixel of a place in the scene.
    #[must_use]
    pub fn pixel(&self, place: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.view.center();
        let [width, height] = self.extent();
        let scale = self.view.scale();
        [width / 2.0 + (place[0] - x) * scale, height / 2.0 - (place[1] - y) * scale]
    }

    /// The present view.
    #[must_use]
    pub const fn view(&self) -> View {
        self.view
    }

    /// The width and height of the picture, in pixels.
    #[must_use]
    pub const fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The size of symbols relative to that in a picture of usual size.
    pub(crate) fn symbol_size(&self) -> f32 {
        let [width, height] = self.extent();
        #[expect(clippy::cast_possible_truncation, reason = "between 0.2 and 2")]
        let size = (1.3 * width.min(height) / USUAL).clamp(0.2, 2.0) as f32;
        size
    }

    /// The width and height of the picture as floats.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "no picture is 2⁵² pixels wide")]
    pub fn extent(&self) -> [f64; 2] {
        self.size.map(|pixels| pixels as f64)
    }
}

fn fit_motion([low, high]: [[f64; 2]; 2], size: [usize; 2]) -> View {
    let [width, height] = size;
    #[expect(clippy::cast_precision_loss, reason = "no picture is 2⁵² pixels wide")]
    let shorter = width.min(height) as f64;
    View::fit(low, high, width, height, MARGIN * shorter)
}

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
