//! What is seen of a mechanism, and the box around it.

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

/// The points that are seen: corners and centres of shapes, or joints and named points where there is no shape.
pub(super) struct SeenPoints {
    /// The box around what the ground carries.
    pub(super) ground: Sides,
    /// For each pose its points, and the radius of what is seen around each.
    moving: Vec<Vec<Reach>>,
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
        for (point, radius) in points(LinkId::GROUND) {
            grow(&mut ground, point, radius);
        }
        Self {
            ground,
            moving: program.stored.iter().map(|&id| points(id)).collect(),
        }
    }

    /// How many points move.
    pub(super) fn count(&self) -> usize {
        self.moving.iter().map(Vec::len).sum()
    }

    /// The box around everything that moves, if the links have these poses.
    pub(super) fn sides(&self, poses: &[[f64; 4]]) -> Sides {
        let mut sides = EMPTY;
        for (&[cos, sin, x, y], points) in poses.iter().zip(&self.moving) {
            for &([u, v], radius) in points {
                let point = [x + cos * u - sin * v, y + sin * u + cos * v];
                grow(&mut sides, point, radius);
            }
        }
        sides
    }
}

fn grow(sides: &mut Sides, [x, y]: [f64; 2], radius: f64) {
    for (side, out) in sides.iter_mut().zip([-x, -y, x, y]) {
        *side = side.max(out + radius);
    }
}
