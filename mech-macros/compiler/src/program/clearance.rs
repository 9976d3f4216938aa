//! The clearance of two bodies: the least distance of their shapes, whatever planes these lie in.
//!
//! Two bodies that do not overlap are nearest at a corner of one of them. As they move, they touch there before they overlap: where a
//! motion begins without an overlap, and all corners keep clear, there is none.

use super::builder::SsaBuilder;
use super::node::Value;
use crate::model::{Boundary, Corner, Curve, LinkId, Model, ShapeKind};
use crate::plan::{Algebra, Numbers};

/// An arithmetic that knows which of two numbers is the greater.
pub(super) trait Ordered<S: Copy>: Algebra<S> {
    fn greater(&mut self, a: S, b: S) -> S;

    fn lesser(&mut self, a: S, b: S) -> S {
        let (a, b) = (self.neg(a), self.neg(b));
        let greater = self.greater(a, b);
        self.neg(greater)
    }

    /// The distance from the origin.
    fn length(&mut self, v: [S; 2]) -> S {
        let square = self.dot(v, v);
        self.sqrt(square)
    }
}

impl Ordered<f64> for Numbers {
    fn greater(&mut self, a: f64, b: f64) -> f64 {
        a.max(b)
    }
}

impl Ordered<Value> for SsaBuilder {
    fn greater(&mut self, a: Value, b: Value) -> Value {
        self.max(a, b)
    }
}

/// The corners of two bodies, each with the number of the body that it belongs to: first those of the first.
pub(crate) fn corners(boundaries: &[Boundary; 2]) -> Vec<(usize, Corner)> {
    let own = |number: usize| boundaries[number].corners.iter();
    let all = [0, 1].into_iter();
    all.flat_map(|number| own(number).map(move |corner| (number, *corner))).collect()
}

/// The distance of a corner from all curves of another body, in whose frame it is where `place` puts it. Where the corner is across a
/// curve, that is negative or that from its other side.
pub(super) fn gap<S: Copy, A: Ordered<S>>(
    a: &mut A,
    corner: Corner,
    curves: &[Curve],
    place: impl Fn(&mut A, [f64; 2]) -> [S; 2],
) -> Option<S> {
    let at = place(a, corner.middle());
    let mut least = None;
    for curve in curves {
        let own = gap_of_curve(a, corner, at, *curve);
        least = Some(match least {
            Some(least) => a.lesser(least, own),
            None => own,
        });
    }
    least
}

fn gap_of_curve<S: Copy, A: Ordered<S>>(a: &mut A, corner: Corner, at: [S; 2], curve: Curve) -> S {
    match (corner, curve) {
        (Corner::End { radius, .. }, Curve::Line { ends, radius: own }) => {
            let apart = from_line(a, at, ends);
            let both = a.constant(radius + own);
            a.sub(apart, both)
        }
        (Corner::End { radius, .. }, Curve::Circle { center, radius: own }) => {
            let apart = from_place(a, at, center);
            let (outside, inside) = (a.constant(own + radius), a.constant(own - radius));
            either_side(a, [apart, apart], [outside, inside])
        }
        (Corner::Circle { radius, .. }, Curve::Line { ends, radius: own }) => {
            let apart = from_line(a, at, ends);
            let far = ends.map(|end| from_place(a, at, end));
            let far = a.greater(far[0], far[1]);
            let (outside, inside) = (a.constant(radius + own), a.constant(radius - own));
            either_side(a, [apart, far], [outside, inside])
        }
        (Corner::Circle { radius, .. }, Curve::Circle { center, radius: own }) => {
            let apart = from_place(a, at, center);
            let (outside, inside) = (a.constant(radius + own), a.constant((radius - own).abs()));
            either_side(a, [apart, apart], [outside, inside])
        }
    }
}

/// By how much something is farther away than a limit, or nearer than another, whichever it is.
fn either_side<S: Copy, A: Ordered<S>>(
    a: &mut A,
    [near, far]: [S; 2],
    [outside, inside]: [S; 2],
) -> S {
    let (without, within) = (a.sub(near, outside), a.sub(inside, far));
    a.greater(without, within)
}

fn from_place<S: Copy, A: Ordered<S>>(a: &mut A, at: [S; 2], place: [f64; 2]) -> S {
    let place = a.vector(place);
    let between = a.minus(at, place);
    a.length(between)
}

/// The distance from a line that has two ends.
fn from_line<S: Copy, A: Ordered<S>>(a: &mut A, at: [S; 2], [from, to]: [[f64; 2]; 2]) -> S {
    let way = [to[0] - from[0], to[1] - from[1]];
    let length = way[0].hypot(way[1]);
    if length == 0.0 {
        return from_place(a, at, from);
    }
    let (along, begin) = (a.vector(way.map(|part| part / length)), a.vector(from));
    let between = a.minus(at, begin);
    let (on, across) = (a.dot(along, between), a.cross(along, between));
    let (length, zero) = (a.constant(length), a.constant(0.0));
    let (before, behind) = (a.neg(on), a.sub(on, length));
    let beyond = a.greater(before, behind);
    let beyond = a.greater(beyond, zero);
    a.length([beyond, across])
}

/// The least distance of the shapes of two links, in scene units: zero where they overlap. Nothing if one has no shape, or a figure.
/// Poses are those of the links: cosine, sine and origin.
#[must_use]
pub fn clearance(model: &Model, links: [LinkId; 2], poses: [[f64; 4]; 2]) -> Option<f64> {
    let boundaries = Boundary::of_both(model, links)?;
    let gaps = corners(&boundaries).into_iter().filter_map(|(own, corner)| {
        let [from, to] = [poses[own], poses[1 - own]];
        let curves = &boundaries[1 - own].curves;
        gap(&mut Numbers, corner, curves, |_, at| moved(from, to, at))
    });
    let least = gaps.fold(f64::INFINITY, f64::min);
    let holds = |inner: usize, outer: usize| {
        let shapes = &model.link(links[outer]).shapes;
        let corners = boundaries[inner].corners.iter();
        corners.map(|corner| corner.place()).any(|at| {
            let at = moved(poses[inner], poses[outer], at);
            shapes.iter().any(|shape| contains(&shape.kind, at))
        })
    };
    let overlaps = least <= 0.0 || lines_cross(&boundaries, poses) || holds(0, 1) || holds(1, 0);
    Some(if overlaps { 0.0 } else { least })
}

/// A place of one link in the frame of another.
fn moved(from: [f64; 4], to: [f64; 4], [u, v]: [f64; 2]) -> [f64; 2] {
    let [cos, sin, x, y] = from;
    let [x, y] = [x + cos * u - sin * v - to[2], y + sin * u + cos * v - to[3]];
    [to[0] * x + to[1] * y, to[0] * y - to[1] * x]
}

/// Whether lines of two boundaries cross each other.
fn lines_cross(boundaries: &[Boundary; 2], poses: [[f64; 4]; 2]) -> bool {
    let lines = |number: usize| {
        let lines = boundaries[number].curves.iter().filter_map(|curve| match curve {
            Curve::Line { ends, .. } => Some(*ends),
            Curve::Circle { .. } => None,
        });
        lines.map(move |ends| ends.map(|end| moved(poses[number], poses[0], end)))
    };
    // Whether both ends of one lie on two sides of the other.
    let parts = |[a, b]: [[f64; 2]; 2], ends: [[f64; 2]; 2]| {
        let side = ends.map(|[x, y]| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]));
        side[0] * side[1] < 0.0
    };
    lines(0).any(|one| lines(1).any(|other| parts(one, other) && parts(other, one)))
}

/// Whether a shape covers a place of its link.
fn contains(shape: &ShapeKind, at @ [x, y]: [f64; 2]) -> bool {
    let apart = |[u, v]: [f64; 2]| (x - u).hypot(y - v);
    match shape {
        ShapeKind::Circle { center, radius } => apart(*center) <= *radius,
        ShapeKind::Ring { center, radius, hole } => (*hole..=*radius).contains(&apart(*center)),
        ShapeKind::Bar { pins, width } => pins
            .windows(2)
            .any(|pins| from_line(&mut Numbers, at, [pins[0], pins[1]]) <= 0.5 * width),
        ShapeKind::Polygon(corners) => {
            let next = corners.iter().cycle().skip(1);
            let above = corners.iter().zip(next).filter(|([u, v], [p, q])| {
                (*v > y) != (*q > y) && x < u + (p - u) * (y - v) / (q - v)
            });
            above.count() % 2 == 1
        }
        ShapeKind::Figure(_) => false,
    }
}
