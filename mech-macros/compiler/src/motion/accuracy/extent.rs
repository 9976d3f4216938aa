//! The errors of places on links: an error of a link's angle moves its far end in proportion to the arm.

use crate::model::{LinkId, Model};
use crate::program::Position;
use mech_core::Real;

/// For each link whose pose is kept, the corners of a box around its axes and shapes. When the link is off, no place in the box is
/// farther off than one of the corners.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Extents(Vec<[[f64; 2]; 4]>);

impl Extents {
    pub(super) fn of(model: &Model, stored: &[LinkId]) -> Self {
        let corners = stored.iter().map(|&id| {
            let mut low = [f64::INFINITY; 2];
            let mut high = [f64::NEG_INFINITY; 2];
            // A circle is where its middle is.
            let in_shapes = model.link(id).shape_points().map(|(point, _)| point);
            for point in model.axis_places(id).chain(in_shapes) {
                for index in 0..2 {
                    low[index] = low[index].min(point[index]);
                    high[index] = high[index].max(point[index]);
                }
            }
            if low[0] > high[0] {
                return [[0.0; 2]; 4];
            }
            [low, [low[0], high[1]], [high[0], low[1]], high]
        });
        Self(corners.collect())
    }

    /// Returns the greatest error of a place on each link.
    pub(super) fn displacements<T: Real>(
        &self,
        is: &Position<T>,
        should: &Position<f64>,
    ) -> impl Iterator<Item = f64> {
        let poses = is.poses.iter().zip(&should.poses).zip(&self.0);
        poses.map(|((is, should), corners)| {
            let mut off = [0.0; 4];
            for ((off, is), should) in off.iter_mut().zip(is).zip(should) {
                *off = is.to_f64() - should;
            }
            let [cos, sin, x, y] = off;
            let moved = |[a, b]: [f64; 2]| (x + cos * a - sin * b).hypot(y + sin * a + cos * b);
            corners.iter().copied().map(moved).fold(0.0, f64::max)
        })
    }

    /// The greatest of the numbers that it takes to say where the links are: rounding is relative to these.
    pub(super) fn reach(&self, position: &Position<f64>) -> f64 {
        let spots = self.0.iter().flatten().flatten();
        let origins = position.poses.iter().flat_map(|pose| &pose[2..]);
        let motors = &position.motors;
        spots.chain(origins).chain(motors).fold(0.0, |reach, number| reach.max(number.abs()))
    }
}
