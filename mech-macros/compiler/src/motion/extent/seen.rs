//! The places that are seen of a mechanism, and the box around it.

use crate::model::{LinkId, Model};
use crate::program::Program;

/// A point of a shape, in the frame of its link, and how far the shape reaches around it.
pub(crate) type Reach = ([f64; 2], f64);

/// The left, lower, right and upper side of a box.
pub(super) const SIDES: [usize; 4] = [0, 1, 2, 3];

/// The sides of an upright box, each with its sign so that greater is farther out: −left, −lower, right, upper.
pub(super) type Sides = [f64; 4];

/// A box that holds nothing.
pub(super) const EMPTY: Sides = [f64::NEG_INFINITY; 4];

/// The sides of the box around a link, and the number of the point that is outermost on each.
#[derive(Clone, Copy)]
pub(super) struct Outermost {
    pub(super) sides: Sides,
    pub(super) points: [u32; 4],
}

/// The points that are seen: corners and centres of shapes, or joints and named points where there is no shape.
pub(super) struct SeenPoints {
    /// The box around what the ground carries.
    pub(super) ground: Sides,
    /// For each pose its points that may be outermost, and the radius of what is seen around each.
    pub(super) moving: Vec<Vec<Reach>>,
}

impl SeenPoints {
    pub(super) fn new(model: &Model, program: &Program, shapes: &[Vec<Reach>]) -> Self {
        let has_shapes = shapes.iter().any(|points| !points.is_empty());
        let points = |id: LinkId| -> Vec<Reach> {
            if has_shapes {
                shapes[id.index()].clone()
            } else {
                model.axis_places(id).map(|place| (place, 0.0)).collect()
            }
        };
        let mut ground = EMPTY;
        for reach in points(LinkId::GROUND) {
            for (side, out) in ground.iter_mut().zip(outwards(reach, [1.0, 0.0, 0.0, 0.0])) {
                *side = side.max(out);
            }
        }
        let moving = program.stored.iter();
        let moving = moving.map(|&id| outer(points(id))).collect();
        Self { ground, moving }
    }

    /// The greatest number that it takes to say where a point is in its link.
    pub(super) fn size(&self) -> f64 {
        let numbers = |&([x, y], radius): &Reach| x.abs().max(y.abs()) + radius;
        self.moving.iter().flatten().map(numbers).fold(0.0, f64::max)
    }

    /// Returns the number of points that move.
    pub(super) fn count(&self) -> usize {
        self.moving.iter().map(Vec::len).sum()
    }

    /// Returns the outermost places of each link, if the links have these poses.
    pub(super) fn outermost(&self, poses: &[[f64; 4]]) -> Vec<Outermost> {
        let poses = poses.iter().enumerate();
        poses.map(|(link, pose)| self.of_link(link, *pose)).collect()
    }

    /// Returns the outermost places of a link, if it has this pose.
    pub(super) fn of_link(&self, link: usize, pose: [f64; 4]) -> Outermost {
        let mut found = Outermost { sides: EMPTY, points: [0; 4] };
        for (number, &point) in (0..).zip(&self.moving[link]) {
            let out = outwards(point, pose);
            for side in SIDES {
                if out[side] > found.sides[side] {
                    found.sides[side] = out[side];
                    found.points[side] = number;
                }
            }
        }
        found
    }
}

/// Returns the sides of the box around a point's shape, if its link has this pose.
pub(super) fn outwards(([u, v], radius): Reach, [cos, sin, x, y]: [f64; 4]) -> Sides {
    let [x, y] = [x + cos * u - sin * v, y + sin * u + cos * v];
    [radius - x, radius - y, radius + x, radius + y]
}

/// The points that may be outermost in some direction: the corners of the convex hull, for each radius by itself.
fn outer(mut points: Vec<Reach>) -> Vec<Reach> {
    points.sort_by(|([ax, ay], a), ([bx, by], b)| {
        b.total_cmp(a).then(ax.total_cmp(bx)).then(ay.total_cmp(by))
    });
    points.dedup();
    let groups = points.chunk_by(|a, b| a.1 == b.1);
    let mut corners: Vec<Reach> = Vec::new();
    for group in groups {
        let half = |points: &mut dyn Iterator<Item = &Reach>| {
            let mut half: Vec<Reach> = Vec::new();
            for &(next, radius) in points {
                while let [.., (before, _), (last, _)] = half[..]
                    && turns_right(before, last, next)
                {
                    half.pop();
                }
                half.push((next, radius));
            }
            half
        };
        // Discs of greater radius come first: what lies within one is never outermost.
        let is_hidden = |&(at, radius): &Reach, corners: &[Reach]| {
            let hides = |(other, most): &Reach| {
                (other[0] - at[0]).hypot(other[1] - at[1]) + radius <= *most
            };
            corners.iter().any(hides)
        };
        let mut all = half(&mut group.iter());
        all.extend(half(&mut group.iter().rev()));
        all.sort_by(|([ax, ay], _), ([bx, by], _)| ax.total_cmp(bx).then(ay.total_cmp(by)));
        all.dedup();
        all.retain(|point| !is_hidden(point, &corners));
        corners.extend(all);
    }
    corners
}

/// Whether a way through three points turns to the right, or not at all.
fn turns_right(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> bool {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0.0
}
