//! Lines of a width in pixels, and links as bars.

use super::{Canvas, Palette};
use crate::{Outline, Pose, Real, Scalar};

/// Draws a straight line between two places in the scene, `width` pixels wide at any scale, in entry `color` of the palette. Its ends are
/// round. A line that is not finite is not drawn.
///
/// ```
/// use mech_runtime::{Frame, raster};
///
/// let mut frame = Frame::<64, 48>::new();
/// raster::line(&mut frame, [[-20.0_f32, 0.0], [20.0, 10.0]], 1.5, 14);
/// assert_eq!(frame.pixel(32, 19), Some(14));
/// ```
pub fn line<T: Scalar>(canvas: &mut impl Canvas<T>, ends: [[T; 2]; 2], width: T, color: u8) {
    let width = width / canvas.scale();
    let line = Outline::Line { points: &ends, width };
    canvas.fill(line, Pose::identity(), color);
}

/// Draws a link as textbooks do: a bar along its pins, with an eye at each. The pins are points of a link at `pose`. `width` is in scene
/// units. The edge of the bar is [darker](Palette::darker) than entry `color` of the palette.
///
/// ```
/// use mech_runtime::{Frame, Palette, Pose, raster};
///
/// let mut frame = Frame::<64, 48>::new();
/// raster::bar(&mut frame, &[[-20.0, 0.0], [20.0, 0.0]], Pose::identity(), 9.0, Palette::BLUE);
/// assert_eq!(frame.pixel(32, 24), Some(Palette::BLUE));
/// assert_eq!(frame.pixel(12, 24), Some(Palette::EYE));
/// ```
pub fn bar<T: Scalar>(
    canvas: &mut impl Canvas<T>,
    pins: &[[T; 2]],
    pose: Pose<T>,
    width: T,
    color: u8,
) {
    let part = |share: f64| <T as Real>::from_f64(share) * width;
    let mut line = |width, color| {
        let points = pins;
        canvas.fill(Outline::Line { points, width }, pose, color);
    };
    line(width, Palette::darker(color));
    line(part(0.76), color);
    for &center in pins {
        let mut disc = |radius, color| canvas.fill(Outline::Circle { center, radius }, pose, color);
        disc(part(0.28), Palette::INK);
        disc(part(0.14), Palette::EYE);
    }
}
