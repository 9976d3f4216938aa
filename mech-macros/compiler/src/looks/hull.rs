//! Convex hulls.

use nalgebra::{Point2, Vector2};

/// The corners of the convex hull, as indices, counter-clockwise. Fewer than three if all points lie within a strip of this width.
pub(super) fn hull(points: &[Point2<f64>], width: f64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| {
        let [a, b] = [points[a], points[b]];
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
    });
    let lower = chain(points, order.iter().copied());
    let upper = chain(points, order.iter().rev().copied());
    let corners: Vec<usize> = [&lower[..lower.len() - 1], &upper[..upper.len() - 1]].concat();
    if is_thin(points, &corners, width) { Vec::new() } else { corners }
}

/// One side of the hull of ordered points.
fn chain(points: &[Point2<f64>], order: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut side: Vec<usize> = Vec::new();
    for next in order {
        while let [.., a, b] = side[..] {
            let turn = (points[b] - points[a]).perp(&(points[next] - points[b]));
            if turn > 0.0 {
                break;
            }
            side.pop();
        }
        side.push(next);
    }
    side
}

/// Whether a hull is nowhere wider than this.
fn is_thin(points: &[Point2<f64>], corners: &[usize], width: f64) -> bool {
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    edges.map(|(&a, &b)| breadth(points, corners, a, b)).fold(f64::INFINITY, f64::min) < width
}

/// Returns the greatest distance of corners from the line through two of them.
fn breadth(points: &[Point2<f64>], corners: &[usize], a: usize, b: usize) -> f64 {
    let along = points[b] - points[a];
    let length = along.norm().max(f64::MIN_POSITIVE);
    let away = corners.iter().map(|&corner| along.perp(&(points[corner] - points[a])).abs());
    away.fold(0.0, f64::max) / length
}

/// Returns the distance of a point from the edge of a convex polygon with counter-clockwise corners; negative outside of it.
pub(super) fn depth(corners: &[Point2<f64>], point: Point2<f64>) -> f64 {
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let depths = edges.map(|(a, b)| {
        let along: Vector2<f64> = b - a;
        along.perp(&(point - a)) / along.norm().max(f64::MIN_POSITIVE)
    });
    depths.fold(f64::INFINITY, f64::min)
}

/// The distance of a point from a straight line between two points. By numbers, as macros are mostly built without optimisation, and this
/// is asked for often.
pub(super) fn distance_to([a, b]: [Point2<f64>; 2], point: Point2<f64>) -> f64 {
    let along = [b.x - a.x, b.y - a.y];
    let [x, y] = [point.x - a.x, point.y - a.y];
    let square = along[0] * along[0] + along[1] * along[1];
    let part =
        if square > 0.0 { ((x * along[0] + y * along[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    let [x, y] = [x - along[0] * part, y - along[1] * part];
    (x * x + y * y).sqrt()
}
