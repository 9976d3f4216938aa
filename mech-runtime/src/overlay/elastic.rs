//! Springs and dampers.

use super::pen::{MEDIUM, Pen, Spot, THIN};
use crate::{Canvas, Real, Scalar};

/// Half the width of a spring, and the number of its coils.
const AMPLITUDE: f32 = 5.0;
const COILS: u8 = 6;
/// The straight part at both ends of a spring or damper.
const LEAD: f32 = 8.0;
/// Half the length and half the width of a damper's cylinder, and half the width of its piston.
const CYLINDER: [f32; 2] = [9.0, 5.5];
const PISTON: f32 = 3.5;
/// The radius of a spiral spring's inner half turn, and by how much each next one is larger.
const SPIRAL: [f32; 2] = [7.0, 3.0];

/// The first of two places, looking at the other, and their distance in pixels; none if that is no number, or zero.
fn between<T: Scalar>(pen: &Pen<T>, ends: [[T; 2]; 2]) -> Option<(Spot<T>, f32)> {
    let (spot, length) = Spot::between(ends)?;
    let pixels = pen.in_pixels(length);
    (pixels.is_finite() && pixels > 0.0).then_some((spot, pixels))
}

/// A zigzag between two places, so many pixels to the left of the line between them.
pub(super) fn spring<T: Scalar>(
    pen: &Pen<T>,
    canvas: &mut dyn Canvas<T>,
    ends: [[T; 2]; 2],
    beside: f32,
) {
    let Some((spot, length)) = between(pen, ends) else {
        return;
    };
    let lead = LEAD.min(0.2 * length);
    let half_coil = (length - 2.0 * lead) / f32::from(2 * COILS);
    let mut half_coils = lead + 0.5 * half_coil;
    let mut side = -AMPLITUDE;
    let mut places = [[length, 0.0]; 2 * COILS as usize + 4];
    let [first, start, peaks @ .., end, _] = &mut places;
    (*first, *start, *end) = ([0.0; 2], [lead, beside], [length - lead, beside]);
    for peak in peaks {
        side = -side;
        *peak = [half_coils, beside + side];
        half_coils += half_coil;
    }
    pen.path(canvas, spot, places);
}

/// A cylinder and its piston between two places, so many pixels to the left of the line between them.
pub(super) fn damper<T: Scalar>(
    pen: &Pen<T>,
    canvas: &mut dyn Canvas<T>,
    ends: [[T; 2]; 2],
    beside: f32,
) {
    let Some((spot, length)) = between(pen, ends) else {
        return;
    };
    let (lead, middle) = (LEAD.min(0.2 * length), 0.5 * length);
    let [half, width] = [CYLINDER[0].min(0.25 * length), CYLINDER[1]];
    let (open, closed) = (middle - half, middle + half);
    let [left, right] = [beside + width, beside - width];
    pen.path(canvas, spot, [[0.0, 0.0], [lead, beside], [middle, beside]]);
    pen.path(canvas, spot, [[middle, beside - PISTON], [middle, beside + PISTON]]);
    pen.path(canvas, spot, [[open, left], [closed, left], [closed, right], [open, right]]);
    pen.path(canvas, spot, [[closed, beside], [length - lead, beside], [length, 0.0]]);
}

/// A spiral about a pin.
pub(super) fn torsion_spring<T: Scalar>(pen: &Pen<T>, canvas: &mut dyn Canvas<T>, at: [T; 2]) {
    let spot = Spot::upright(at);
    let place = |x: f32| [pen.pixels(x), T::ZERO];
    let half_turn = <T as Real>::TURN * <T as Real>::HALF;
    let [radius, growth] = SPIRAL;
    let mut end = -radius;
    // Half turns about two centres in turn, each of which begins where the last one ends.
    for number in 0..3 {
        let center = if number % 2 == 0 { 0.0 } else { -growth };
        pen.arc(canvas, spot, [center, end].map(place), half_turn, MEDIUM);
        end = center + (center - end);
    }
    pen.path(canvas, spot, [[end, 0.0], [end + 4.0, 0.0]]);
}

/// A cylinder and its piston, bent about a pin.
pub(super) fn torsion_damper<T: Scalar>(pen: &Pen<T>, canvas: &mut dyn Canvas<T>, at: [T; 2]) {
    /// The directions at 60°, 90° and 120°.
    const BEGIN: [f32; 2] = [0.5, 0.866];
    const MIDDLE: [f32; 2] = [0.0, 1.0];
    const END: [f32; 2] = [-0.5, 0.866];
    const RADIUS: f32 = 12.0;
    const HALF: f32 = 4.0;
    let spot = Spot::upright(at);
    let away = |[x, y]: [f32; 2], radius: f32| [x * radius, y * radius];
    let mut arc = |from: [f32; 2], radius: f32, degrees: f32, width: f32| {
        let start = away(from, radius).map(|part| pen.pixels(part));
        let angle = <T as Real>::TURN * T::from_f32(degrees / 360.0);
        pen.arc(canvas, spot, [[T::ZERO; 2], start], angle, width);
    };
    arc(BEGIN, RADIUS - HALF, 60.0, MEDIUM);
    arc(BEGIN, RADIUS + HALF, 60.0, MEDIUM);
    arc([1.0, 0.0], RADIUS, 90.0, THIN);
    arc(END, RADIUS, 60.0, THIN);
    let across = |direction, half| [away(direction, RADIUS - half), away(direction, RADIUS + half)];
    pen.path(canvas, spot, across(END, HALF));
    pen.path(canvas, spot, across(MIDDLE, 0.6 * HALF));
}
