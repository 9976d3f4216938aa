//! Marks that a player draws into the scene.

use mech_runtime::{Canvas, Outline, Palette, Pose, raster};

/// The radius of a ring and its width, in pixels.
const RING: [f64; 2] = [13.0, 3.5];
/// The least of both, for large pixels.
const LEAST: [f64; 2] = [2.2, 0.9];

/// A red ring about a place that stops a move, so many times as large as usual.
pub(super) fn ring(canvas: &mut impl Canvas<f64>, center: [f64; 2], size: f32) {
    let scale = canvas.scale();
    let length = |usual: f64, least: f64| (usual * f64::from(size)).max(least) / scale;
    let [middle, width] = [length(RING[0], LEAST[0]), length(RING[1], LEAST[1])];
    let ring = Outline::Ring { center, radius: middle + width / 2.0, hole: middle - width / 2.0 };
    canvas.fill(ring, Pose::identity(), Palette::RED);
}

/// A line from the held place to the pointer.
pub(super) fn band(canvas: &mut impl Canvas<f64>, ends: [[f64; 2]; 2], size: f32) {
    raster::line(canvas, ends, f64::from(size), Palette::INK);
}
