//! Outlines as the rasteriser takes them.

use mech_compiler::{Measure, Outline, Painted, Place};
use mech_runtime::{Canvas, Pose};

/// An outline of a link, with its colour.
pub(super) struct Shape {
    /// 0 is the ground.
    link: usize,
    figure: Figure,
    color: u8,
}

/// An outline whose numbers are known.
enum Figure {
    Circle {
        center: [f64; 2],
        radius: f64,
    },
    Ring {
        center: [f64; 2],
        radius: f64,
        hole: f64,
    },
    Polygon(Vec<[f64; 2]>),
    Line {
        points: Vec<[f64; 2]>,
        width: f64,
    },
    Arc {
        center: [f64; 2],
        start: [f64; 2],
        angle: f64,
        width: f64,
    },
}

impl Shape {
    /// What is painted of a link with this number.
    pub(super) fn new(link: usize, painted: &Painted) -> Self {
        Self {
            link,
            figure: Figure::new(&painted.outline),
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
            canvas.fill(self.figure.outline(), pose, self.color);
        }
    }
}

impl Figure {
    fn new(outline: &Outline) -> Self {
        let place = |place: &Place| place.map(Measure::at_start);
        let places = |places: &[Place]| places.iter().map(place).collect();
        match outline {
            Outline::Circle { center, radius } => Self::Circle {
                center: place(center),
                radius: radius.at_start(),
            },
            Outline::Ring {
                center,
                radius,
                hole,
            } => Self::Ring {
                center: place(center),
                radius: radius.at_start(),
                hole: hole.at_start(),
            },
            Outline::Polygon(corners) => Self::Polygon(places(corners)),
            Outline::Toothed(wheel) => Self::Polygon(wheel.corners()),
            Outline::Line { points, width } => Self::Line {
                points: places(points),
                width: width.at_start(),
            },
            Outline::Arc {
                center,
                start,
                angle,
                width,
            } => Self::Arc {
                center: *center,
                start: *start,
                angle: *angle,
                width: *width,
            },
        }
    }

    fn outline(&self) -> mech_runtime::Outline<'_, f64> {
        use mech_runtime::Outline as Painted;
        match *self {
            Self::Circle { center, radius } => Painted::Circle { center, radius },
            Self::Ring {
                center,
                radius,
                hole,
            } => Painted::Ring {
                center,
                radius,
                hole,
            },
            Self::Polygon(ref corners) => Painted::Polygon(corners),
            Self::Line { ref points, width } => Painted::Line { points, width },
            Self::Arc {
                center,
                start,
                angle,
                width,
            } => Painted::Arc {
                center,
                start,
                angle,
                width,
            },
        }
    }
}
