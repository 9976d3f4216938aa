//! Many shapes as a table: the compiler reads rows of numbers in half the time that it takes for as many structs.

use crate::{Outline, Shape};
use mech_core::wheel::{fill_ring, fill_wheel};

/// The shapes of a table. A row has the link, the colour, the kind of the outline, and how many points it has or which wheel it is.
/// The outlines take their numbers and points one after the other.
///
/// # Panics
/// Rows ask for more than there is: no macro writes that.
#[must_use]
pub const fn shapes<T: Copy, const N: usize>(
    rows: [[usize; 4]; N],
    numbers: &[T],
    points: &'static [[T; 2]],
    wheels: &[&'static [[T; 2]]],
) -> [Shape<T>; N] {
    let nothing = Shape { link: 0, outline: Outline::Polygon(&[]), color: 0 };
    let mut shapes = [nothing; N];
    let (mut numbers, mut points) = (numbers, points);
    let mut row = 0;
    while row < N {
        let [link, color, kind, count] = rows[row];
        let outline = match kind {
            0 => {
                let [x, y, radius] = take(&mut numbers);
                let center = [x, y];
                Outline::Circle { center, radius }
            }
            1 => {
                let [x, y, radius, hole] = take(&mut numbers);
                let center = [x, y];
                Outline::Ring { center, radius, hole }
            }
            2 => Outline::Polygon(take_points(&mut points, count)),
            3 => {
                let [width] = take(&mut numbers);
                let points = take_points(&mut points, count);
                Outline::Line { points, width }
            }
            4 => {
                let [x, y, u, v, angle, width] = take(&mut numbers);
                Outline::Arc { center: [x, y], start: [u, v], angle, width }
            }
            _ => Outline::Polygon(wheels[count]),
        };
        #[expect(
            clippy::cast_possible_truncation,
            reason = "an entry of the palette, which has 256 at most"
        )]
        let color = color as u8;
        shapes[row] = Shape { link, outline, color };
        row += 1;
    }
    shapes
}

/// The next numbers.
const fn take<T: Copy, const N: usize>(numbers: &mut &[T]) -> [T; N] {
    let Some((next, others)) = numbers.split_first_chunk() else {
        panic!("a table of shapes lacks numbers");
    };
    *numbers = others;
    *next
}

/// The next points.
const fn take_points<T>(points: &mut &'static [[T; 2]], count: usize) -> &'static [[T; 2]] {
    let (next, others) = points.split_at(count);
    *points = others;
    next
}

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
