//! Outlines as the rasteriser takes them.

use mech_compiler::model::{Measure, Place};
use mech_compiler::{Outline, Painted};
use mech_runtime::{Canvas, Pose};

/// An outline of a link, with its colour.
pub(super) struct Shape {
    /// 0 is the ground.
    pub(super) link: usize,
    outline: Outline,
    /// The corners of a polygon or a wheel, or the points of a line.
    points: Vec<[f64; 2]>,
    color: u8,
}

impl Shape {
    /// What is painted of a link with this number.
    pub(super) fn new(link: usize, painted: &Painted) -> Self {
        let points = match &painted.outline {
            Outline::Polygon(places) | Outline::Line { points: places, .. } => {
                places.iter().map(at_start).collect()
            }
            Outline::Toothed(wheel) => wheel.corners(),
            Outline::Circle { .. } | Outline::Ring { .. } | Outline::Arc { .. } => Vec::new(),
        };
        Self {
            link,
            outline: painted.outline.clone(),
            points,
            color: painted.color,
        }
    }

    /// Paints it on its link, if the pose of that is known.
    pub(super) fn paint(&self, poses: &[Pose<f64>], canvas: &mut impl Canvas<f64>) {
        let pose = match self.link.checked_sub(1) {
            None => Some(Pose::identity()),
            Some(moving) => poses.get(moving).copied(),
        };
        if let Some(pose) = pose {
            canvas.fill(self.filled(), pose, self.color);
        }
    }

    /// The outline as the rasteriser takes it.
    pub(super) fn filled(&self) -> mech_runtime::Outline<'_, f64> {
        use mech_runtime::Outline as Filled;
        match &self.outline {
            Outline::Circle { center, radius } => Filled::Circle {
                center: at_start(center),
                radius: radius.at_start(),
            },
            Outline::Ring {
                center,
                radius,
                hole,
            } => Filled::Ring {
                center: at_start(center),
                radius: radius.at_start(),
                hole: hole.at_start(),
            },
            Outline::Polygon(_) | Outline::Toothed(_) => Filled::Polygon(&self.points),
            Outline::Line { width, .. } => Filled::Line {
                points: &self.points,
                width: width.at_start(),
            },
            &Outline::Arc {
                center,
                start,
                angle,
                width,
            } => Filled::Arc {
                center,
                start,
                angle,
                width,
            },
        }
    }
}

fn at_start(place: &Place) -> [f64; 2] {
    place.map(Measure::at_start)
}
