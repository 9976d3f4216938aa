//! Which places the declared shapes of a link cover.

use super::hull::distance_to;
use crate::model::{Shape, ShapeKind};
use nalgebra::Point2;

/// A place this near to an edge, as a part of its distance from the origin, lies on the edge.
const ON_EDGE: f64 = 1e-9;

/// Whether one of these shapes covers a place, holes included: what is around a pin carries it.
pub(super) fn covers(shapes: &[Shape], place: Point2<f64>) -> bool {
    shapes.iter().any(|shape| is_within(&shape.kind, place))
}

fn is_within(kind: &ShapeKind, place: Point2<f64>) -> bool {
    let (points, reach) = kind.reach();
    let points: Vec<Point2<f64>> = points.iter().copied().map(Point2::from).collect();
    let near = ON_EDGE * place.coords.norm();
    let is_near_line =
        |ends: &[Point2<f64>]| distance_to([ends[0], ends[1]], place) <= reach + near;
    match kind {
        ShapeKind::Bar { .. } => points.windows(2).any(is_near_line),
        ShapeKind::Polygon(_) => {
            let last = [points[points.len() - 1], points[0]];
            is_inside(&points, place) || points.windows(2).any(is_near_line) || is_near_line(&last)
        }
        ShapeKind::Circle { .. } | ShapeKind::Ring { .. } | ShapeKind::Figure(_) => points
            .iter()
            .any(|point| (place - point).norm() <= reach + near),
    }
}

/// Whether a place is inside a polygon, by the even-odd rule.
fn is_inside(corners: &[Point2<f64>], place: Point2<f64>) -> bool {
    let next = corners.iter().cycle().skip(1);
    let crossed = corners.iter().zip(next).filter(|(a, b)| {
        (a.y > place.y) != (b.y > place.y)
            && place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)
    });
    crossed.count() % 2 == 1
}
