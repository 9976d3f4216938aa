//! Arrows for vectors.

use super::pen::{BOLD, MEDIUM, Pen, Spot, looking};
use super::usable;
use crate::{Canvas, Palette, Real, Scalar};

/// The length of an arrow's head and half its width, in pixels.
const HEAD: [f32; 2] = [10.0, 3.6];

/// Arrows of one colour and scale, for velocities, accelerations or forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrows<T> {
    length: T,
    color: u8,
    size: f32,
}

impl<T: Scalar> Arrows<T> {
    /// Arrows in this entry of the palette. A vector of length one is `length` scene units long.
    #[must_use]
    pub const fn new(length: T, color: u8) -> Self {
        let size = 1.0;
        Self { length, color, size }
    }

    /// Sets the thickness relative to the usual one, 1. A size that is not finite and positive becomes 1.
    #[must_use]
    pub const fn size(self, size: f32) -> Self {
        let size = usable(size);
        Self { size, ..self }
    }

    /// Draws a vector at a place in the scene. A vector that is shorter than a pixel or not finite is left out.
    pub fn draw(&self, canvas: &mut impl Canvas<T>, [x, y]: [T; 2], [u, v]: [T; 2]) {
        let tip = [x + self.length * u, y + self.length * v];
        arrow(canvas, [[x, y], tip], self.size, self.color);
    }
}

/// Draws an arrow from one place in the scene to another in entry `color` of the palette, `size` times as thick as usual. An arrow that
/// is shorter than a pixel or not finite is left out.
pub fn arrow<T: Scalar>(
    canvas: &mut impl Canvas<T>,
    [tail, tip]: [[T; 2]; 2],
    size: f32,
    color: u8,
) {
    let pen = Pen::new(canvas, usable(size), color, Palette::EYE);
    let Some((spot, length)) = Spot::between([tail, tip]) else {
        return;
    };
    let pixels = pen.in_pixels(length);
    if pixels.is_nan() || pixels <= 1.0 {
        return;
    }
    // A head longer than the arrow would point from behind.
    let share = (pixels / HEAD[0]).min(1.0);
    let neck = length - pen.pixels(0.8 * share * HEAD[0]);
    pen.line(canvas, spot, [[T::ZERO; 2], [neck, T::ZERO]], BOLD);
    let own = looking([length, T::ZERO], [T::ONE, T::ZERO]);
    head(&pen, canvas, Spot { own, ..spot }, share);
}

/// Draws a curved arrow around a place in the scene, counter-clockwise (to the left) or clockwise. It is open below. Its radius is
/// `radius` pixels, its colour is entry `color` of the palette, and it is `size` times as thick as usual.
pub fn moment<T: Scalar>(
    canvas: &mut impl Canvas<T>,
    center: [T; 2],
    to_the_left: bool,
    radius: f32,
    size: f32,
    color: u8,
) {
    let pen = Pen::new(canvas, usable(size), color, Palette::EYE);
    turn(&pen, canvas, center, to_the_left, radius);
}

/// The same with a pen.
pub(super) fn turn<T: Scalar>(
    pen: &Pen<T>,
    canvas: &mut dyn Canvas<T>,
    center: [T; 2],
    to_the_left: bool,
    radius: f32,
) {
    // From a little below on the one side to a little below on the other; a unit vector, and the angle between.
    const LOW: f64 = -0.35;
    let spot = Spot::upright(center);
    let (sin, cos) = Real::sin_cos(<T as Real>::from_f64(LOW));
    let side = if to_the_left { T::ONE } else { -T::ONE };
    let far = pen.pixels(radius);
    let [start, end] = [side, -side].map(|side| [side * far * cos, far * sin]);
    let angle = side * <T as Real>::from_f64(core::f64::consts::PI - 2.0 * LOW);
    // The arc ends within the head, which is as long as the chord it stands for.
    let shorter = side * <T as Real>::from_f64(f64::from(0.8 * HEAD[0] / radius));
    pen.arc(canvas, spot, [[T::ZERO; 2], start], angle - shorter, MEDIUM);
    // A tangent at the end would point out of the circle: half of the head's angle is taken back.
    let (sin, cos) = Real::sin_cos(<T as Real>::from_f64(LOW + 0.5 * f64::from(HEAD[0] / radius)));
    let own = looking(end, [side * sin, -cos]);
    head(pen, canvas, Spot { own, ..spot }, 1.0);
}

/// The head of an arrow whose tip is at a spot.
pub(super) fn head<T: Scalar>(pen: &Pen<T>, canvas: &mut dyn Canvas<T>, tip: Spot<T>, share: f32) {
    let [length, half] = HEAD.map(|pixels| share * pixels);
    let corners = [[0.0, 0.0], [-length, half], [-length, -half]];
    pen.fill(canvas, tip, corners, pen.ink());
}
