//! Toothed wheels, made from one tooth while the program is compiled.

/// The corners of a wheel: those of a tooth as seen from the centre, again and again. `turn` is the cosine and the sine of a pitch.
#[must_use]
pub const fn wheel<const TOOTH: usize, const ALL: usize>(
    center: [f64; 2],
    tooth: [[f64; 2]; TOOTH],
    turn: [f64; 2],
) -> [[f64; 2]; ALL] {
    let mut corners = [[0.0; 2]; ALL];
    let mut direction = [1.0, 0.0];
    let mut corner = 0;
    while corner < ALL {
        corners[corner] = from(center, tooth[corner % TOOTH], direction);
        corner += 1;
        if corner % TOOTH == 0 {
            direction = turned(turn, direction);
        }
    }
    corners
}

/// The corners of a ring with teeth inside: those of its teeth, then those of its rim, in one line that goes there and back.
#[must_use]
pub const fn ring<const TOOTH: usize, const ALL: usize>(
    center: [f64; 2],
    tooth: [[f64; 2]; TOOTH],
    turn: [f64; 2],
    rim: f64,
) -> [[f64; 2]; ALL] {
    let inside = ALL / 2;
    let mut corners = [[0.0; 2]; ALL];
    let mut direction = [1.0, 0.0];
    let mut corner = 0;
    while corner < inside {
        corners[corner] = from(center, tooth[corner % TOOTH], direction);
        // As many corners for the rim: on the chord of each tooth, out to the rim.
        let part = tooth[corner % TOOTH];
        let length = length(part);
        let out = [part[0] * rim / length, part[1] * rim / length];
        corners[inside + corner] = from(center, out, direction);
        corner += 1;
        if corner % TOOTH == 0 {
            direction = turned(turn, direction);
        }
    }
    corners
}

/// A point as seen from a centre, turned by a direction.
const fn from(center: [f64; 2], point: [f64; 2], direction: [f64; 2]) -> [f64; 2] {
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

/// The same corners.
#[must_use]
pub const fn rounded_f64<const ALL: usize>(corners: [[f64; 2]; ALL]) -> [[f64; 2]; ALL] {
    corners
}

/// The corners in single precision.
#[must_use]
#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding is what is asked for"
)]
pub const fn rounded_f32<const ALL: usize>(corners: [[f64; 2]; ALL]) -> [[f32; 2]; ALL] {
    let mut rounded = [[0.0; 2]; ALL];
    let mut corner = 0;
    while corner < ALL {
        let [x, y] = corners[corner];
        rounded[corner] = [x as f32, y as f32];
        corner += 1;
    }
    rounded
}
