//! What a player draws into the scene.

use mech_examples::Scene;
use mech_runtime::{Canvas, Palette, raster};
use std::f64::consts::TAU;

/// The radius of a ring and its width, in pixels.
const RING: [f64; 2] = [13.0, 3.5];
/// Of how many straight lines it consists.
const SIDES: u32 = 28;

/// A red ring about a place where something is in the way.
pub(crate) fn ring(scene: &mut Scene, [x, y]: [f64; 2], size: f32) {
    let [radius, width] = RING.map(|pixels| pixels * f64::from(size).max(0.35));
    let radius = radius / Canvas::<f64>::scale(scene);
    let corner = |side: u32| {
        let (sin, cos) = (f64::from(side) / f64::from(SIDES) * TAU).sin_cos();
        [x + radius * cos, y + radius * sin]
    };
    for side in 0..SIDES {
        let ends = [corner(side), corner(side + 1)];
        raster::line(scene, ends, width, Palette::RED);
    }
}

/// A line from what is held to the pointer, where that is elsewhere.
pub(crate) fn band(scene: &mut Scene, ends: [[f64; 2]; 2], size: f32) {
    raster::line(scene, ends, f64::from(size), Palette::INK);
}
