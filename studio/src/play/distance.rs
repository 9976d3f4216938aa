//! The distance of a place from the drawn shapes.

use mech_runtime::Outline;

/// The distance of a place from a shape: 0 within it.
pub(super) fn distance_to_shape(at: [f64; 2], outline: &Outline<'_, f64>) -> f64 {
    let from = |[x, y]: [f64; 2]| (at[0] - x).hypot(at[1] - y);
    let beyond = match *outline {
        Outline::Circle { center, radius } => from(center) - radius,
        Outline::Ring { center, radius, hole } => (from(center) - radius).max(hole - from(center)),
        Outline::Polygon(corners) => distance_to_polygon(at, corners, |round| round % 2 != 0),
        Outline::Winding(corners) => distance_to_polygon(at, corners, |round| round != 0),
        Outline::Line { points, width } => {
            let lines = points.windows(2).filter_map(|line| line.try_into().ok());
            let dots = points.iter().map(|&point| [point; 2]);
            nearest(at, lines.chain(dots)) - width / 2.0
        }
        // However far it leads around: who presses within its circle means it.
        Outline::Arc { center, start, width, .. } => {
            let radius = (start[0] - center[0]).hypot(start[1] - center[1]);
            (from(center) - radius).abs() - width / 2.0
        }
    };
    beyond.max(0.0)
}

/// The distance of a place from a polygon. `is_filled` says which winding numbers are inside.
fn distance_to_polygon(at: [f64; 2], corners: &[[f64; 2]], is_filled: impl Fn(i32) -> bool) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let sides = corners.iter().zip(next).map(|(&from, &to)| [from, to]);
    if is_filled(sides.clone().map(|side| crossing(at, side)).sum()) {
        0.0
    } else {
        nearest(at, sides)
    }
}

/// Computes how a side crosses the ray from a place to the right: 1 upwards, −1 downwards, 0 not at all.
fn crossing([x, y]: [f64; 2], [from, to]: [[f64; 2]; 2]) -> i32 {
    let share = (y - from[1]) / (to[1] - from[1]);
    let [is_below, is_above] = [from[1] <= y, to[1] > y];
    if is_below != is_above || x >= from[0] + share * (to[0] - from[0]) {
        0
    } else if is_above {
        1
    } else {
        -1
    }
}

/// The distance of a place from the nearest of these lines.
pub(super) fn nearest(at: [f64; 2], lines: impl Iterator<Item = [[f64; 2]; 2]>) -> f64 {
    lines.map(|line| distance_to_line(at, line)).fold(f64::INFINITY, f64::min)
}

/// The distance of a place from a segment.
pub(crate) fn distance_to_line(at: [f64; 2], line: [[f64; 2]; 2]) -> f64 {
    let [x, y] = nearest_on_line(at, line);
    (at[0] - x).hypot(at[1] - y)
}

/// The place on a segment that is nearest to another.
pub(crate) fn nearest_on_line(at: [f64; 2], [from, to]: [[f64; 2]; 2]) -> [f64; 2] {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let square = x * x + y * y;
    let share = if square > 0.0 {
        (((at[0] - from[0]) * x + (at[1] - from[1]) * y) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    [from[0] + share * x, from[1] + share * y]
}
