//! Toothed wheels, made from one tooth: by the compiler, and in the constants that it writes.

/// Fills in the corners of a wheel: those of a tooth as seen from the centre, again and again. `turn` is the cosine and the sine of a
/// pitch.
pub const fn fill_wheel(
    corners: &mut [[f64; 2]],
    center: [f64; 2],
    tooth: &[[f64; 2]],
    turn: [f64; 2],
) {
    let mut direction = [1.0, 0.0];
    let mut corner = 0;
    while corner < corners.len() {
        corners[corner] = seen_from(center, tooth[corner % tooth.len()], direction);
        corner += 1;
        if corner % tooth.len() == 0 {
            direction = turned(turn, direction);
        }
    }
}

/// Fills in the corners of a ring with teeth inside. They are those of its teeth, then those of its rim, in one line that goes there and back.
/// Each half has a corner more than all teeth, with which it closes.
pub const fn fill_ring(
    corners: &mut [[f64; 2]],
    center: [f64; 2],
    tooth: &[[f64; 2]],
    turn: [f64; 2],
    rim: f64,
) {
    let inside = corners.len() / 2;
    let mut direction = [1.0, 0.0];
    let mut corner = 0;
    while corner < inside {
        let part = tooth[corner % tooth.len()];
        corners[corner] = seen_from(center, part, direction);
        // As many corners for the rim: on the chord of each tooth, out to the rim.
        let length = length(part);
        let out = [part[0] * rim / length, part[1] * rim / length];
        corners[inside + corner] = seen_from(center, out, direction);
        corner += 1;
        if corner % tooth.len() == 0 {
            direction = turned(turn, direction);
        }
    }
}

/// A point as seen from a centre, turned by a direction.
const fn seen_from(center: [f64; 2], point: [f64; 2], direction: [f64; 2]) -> [f64; 2] {
    let [x, y] = turned(point, direction);
    [center[0] + x, center[1] + y]
}

/// The product of two complex numbers.
const fn turned([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}

/// The length of a vector, by Newton's method: no float has a square root in a constant.
const fn length([x, y]: [f64; 2]) -> f64 {
    let square = x * x + y * y;
    let mut root = if square > 1.0 { square } else { 1.0 };
    let mut round = 0;
    while round < 64 {
        root = 0.5 * (root + square / root);
        round += 1;
    }
    root
}
