//! The room that a link takes in its plane.

use super::hull::{depth, distance_to};
use nalgebra::Point2;

/// The area that a link covers, in its own frame.
#[derive(Clone, Default)]
pub(super) struct Footprint {
    /// Bars: their middle lines, and half their width.
    bars: Vec<([Point2<f64>; 2], f64)>,
    /// The corners of a plate, counter-clockwise, and how far it reaches beyond them.
    plate: Option<(Vec<Point2<f64>>, f64)>,
    /// The centre and the radius of the plate's hole.
    hole: Option<(Point2<f64>, f64)>,
    /// Discs: their centres and radii.
    discs: Vec<(Point2<f64>, f64)>,
}

impl Footprint {
    pub(super) fn add_bar(&mut self, ends: [Point2<f64>; 2], width: f64) {
        self.bars.push((ends, 0.5 * width));
    }

    pub(super) fn add_plate(&mut self, corners: Vec<Point2<f64>>, width: f64) {
        self.plate = Some((corners, 0.5 * width));
    }

    pub(super) fn add_hole(&mut self, center: Point2<f64>, radius: f64) {
        self.hole = Some((center, radius));
    }

    pub(super) fn add_disc(&mut self, center: Point2<f64>, radius: f64) {
        self.discs.push((center, radius));
    }

    pub(super) fn is_empty(&self) -> bool {
        self.bars.is_empty() && self.plate.is_none() && self.discs.is_empty()
    }

    /// Whether a disc touches what is covered.
    pub(super) fn touches(&self, center: Point2<f64>, radius: f64) -> bool {
        let mut bars = self.bars.iter();
        let mut discs = self.discs.iter();
        let in_hole = |(middle, open): (Point2<f64>, f64)| (center - middle).norm() + radius < open;
        let plate = self.plate.as_ref();
        let plate = plate.filter(|_| !self.hole.is_some_and(in_hole));
        bars.any(|(ends, half)| distance_to(*ends, center) < half + radius)
            || discs.any(|(other, reach)| (center - other).norm() < reach + radius)
            || plate.is_some_and(|(corners, beyond)| {
                let edges = corners.iter().zip(corners.iter().cycle().skip(1));
                depth(corners, center) > 0.0
                    || edges
                        .map(|(a, b)| distance_to([*a, *b], center))
                        .any(|away| away < beyond + radius)
            })
    }

    /// The smallest box that holds everything: its lower left and its upper right corner.
    pub(super) fn bounds(&self) -> [[f64; 2]; 2] {
        let ends = self.bars.iter();
        let ends = ends.flat_map(|(ends, half)| ends.map(|end| (end, *half)));
        let plate = self.plate.iter();
        let plate = plate.flat_map(|(corners, beyond)| corners.iter().map(|it| (*it, *beyond)));
        let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for (place, around) in ends.chain(plate).chain(self.discs.iter().copied()) {
            for (axis, at) in [place.x, place.y].into_iter().enumerate() {
                bounds[0][axis] = bounds[0][axis].min(at - around);
                bounds[1][axis] = bounds[1][axis].max(at + around);
            }
        }
        bounds
    }

    /// The radius of a circle around the link's origin that holds everything.
    pub(super) fn reach(&self) -> f64 {
        let bars =
            self.bars.iter().flat_map(|(ends, half)| ends.map(|end| end.coords.norm() + half));
        let discs = self.discs.iter().map(|(center, radius)| center.coords.norm() + radius);
        let plate = self.plate.iter().flat_map(|(corners, beyond)| {
            corners.iter().map(move |corner| corner.coords.norm() + beyond)
        });
        bars.chain(discs).chain(plate).fold(0.0, f64::max)
    }
}
