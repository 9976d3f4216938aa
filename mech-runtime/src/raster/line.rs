//! Straight lines of a width in pixels.

use super::Canvas;
use crate::{Real, Scalar};

/// Draws a straight line between two places in the scene, `width` pixels wide however large the scene is seen, with entry
/// `color` of the palette. It goes on for half its width beyond both ends, so that lines that meet leave no notch. What is not
/// finite is not drawn.
///
/// ```
/// use mech_runtime::{Frame, raster};
///
/// let mut frame = Frame::<64, 48>::new();
/// raster::line(&mut frame, [[-20.0_f32, 0.0], [20.0, 10.0]], 1.5, 14);
/// assert_eq!(frame.pixel(32, 19), Some(14));
/// ```
pub fn line<T: Scalar>(canvas: &mut impl Canvas<T>, [from, to]: [[T; 2]; 2], width: T, color: u8) {
    let half = <T as Real>::HALF * width / canvas.scale();
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let length = Real::sqrt(x * x + y * y);
    // A line of no length is a dot.
    let [along, across] = if length > T::ZERO {
        [half * (x / length), half * (y / length)]
    } else {
        [half, T::ZERO]
    };
    let corner = |[x, y]: [T; 2], ahead: T, aside: T| {
        [
            x + ahead * along - aside * across,
            y + ahead * across + aside * along,
        ]
    };
    let (one, minus) = (T::ONE, -T::ONE);
    let corners = [
        corner(from, minus, minus),
        corner(to, one, minus),
        corner(to, one, one),
        corner(from, minus, one),
    ];
    canvas.fill_polygon(&corners, color);
}
