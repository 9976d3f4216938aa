//! Toothed wheels as constants.

use mech_core::wheel::{fill_ring, fill_wheel};

/// The corners of a wheel, from those of its first tooth as seen from the centre. `turn` is the cosine and the sine of a pitch.
#[must_use]
pub const fn wheel<const TOOTH: usize, const ALL: usize>(
    center: [f64; 2],
    tooth: [[f64; 2]; TOOTH],
    turn: [f64; 2],
) -> [[f64; 2]; ALL] {
    let mut corners = [[0.0; 2]; ALL];
    fill_wheel(&mut corners, center, &tooth, turn);
    corners
}

/// The same of a ring with teeth inside, and those of its rim.
#[must_use]
pub const fn ring<const TOOTH: usize, const ALL: usize>(
    center: [f64; 2],
    tooth: [[f64; 2]; TOOTH],
    turn: [f64; 2],
    rim: f64,
) -> [[f64; 2]; ALL] {
    let mut corners = [[0.0; 2]; ALL];
    fill_ring(&mut corners, center, &tooth, turn, rim);
    corners
}

/// The same corners.
#[must_use]
pub const fn rounded_f64<const ALL: usize>(corners: [[f64; 2]; ALL]) -> [[f64; 2]; ALL] {
    corners
}

/// The corners in single precision.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "rounding is what is asked for")]
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
