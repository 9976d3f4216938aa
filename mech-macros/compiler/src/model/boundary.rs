//! The boundaries of bodies, as their declared shapes show them: what could touch another body.

use super::{LinkId, Model, ShapeKind};

/// A curve of the boundary, in the frame of the link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Curve {
    /// All places so far from a straight line.
    Line { ends: [[f64; 2]; 2], radius: f64 },
    /// A circle: of a disc, or of a hole.
    Circle { center: [f64; 2], radius: f64 },
}

/// A part of the boundary that touches another body before its neighbours do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Corner {
    /// The round end of a line; sharp, if the radius is zero.
    End { at: [f64; 2], radius: f64 },
    /// A circle: of a disc, or of a hole.
    Circle { center: [f64; 2], radius: f64 },
}

impl Corner {
    /// Its middle.
    pub(crate) fn middle(self) -> [f64; 2] {
        let (Self::End { at, .. } | Self::Circle { center: at, .. }) = self;
        at
    }

    /// A place of the body, where the middle of a hole is none.
    pub(crate) fn place(self) -> [f64; 2] {
        match self {
            Self::End { at, .. } => at,
            Self::Circle { center: [x, y], radius } => [x + radius, y],
        }
    }
}

/// The boundary of a body.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Boundary {
    pub(crate) curves: Vec<Curve>,
    pub(crate) corners: Vec<Corner>,
}

impl Boundary {
    /// The boundaries of two links; nothing if one has no shape, or a figure.
    pub(crate) fn of_both(model: &Model, links: [LinkId; 2]) -> Option<[Self; 2]> {
        let [first, second] = links.map(|link| Self::of(model, link));
        Some([first?, second?])
    }

    /// The boundary of a link; nothing if it has no shape, or a figure.
    fn of(model: &Model, link: LinkId) -> Option<Self> {
        let shapes = &model.link(link).shapes;
        let mut boundary = Self::default();
        for shape in shapes {
            boundary.add(&shape.kind)?;
        }
        (!shapes.is_empty()).then_some(boundary)
    }

    fn add(&mut self, shape: &ShapeKind) -> Option<()> {
        match shape {
            ShapeKind::Circle { center, radius } => self.add_circle(*center, *radius),
            ShapeKind::Ring { center, radius, hole } => {
                self.add_circle(*center, *radius);
                self.add_circle(*center, *hole);
            }
            ShapeKind::Bar { pins, width } => self.add_lines(pins, 0.5 * width, false),
            ShapeKind::Polygon(corners) => self.add_lines(corners, 0.0, true),
            ShapeKind::Figure(_) => return None,
        }
        Some(())
    }

    fn add_circle(&mut self, center: [f64; 2], radius: f64) {
        self.curves.push(Curve::Circle { center, radius });
        self.corners.push(Corner::Circle { center, radius });
    }

    fn add_lines(&mut self, places: &[[f64; 2]], radius: f64, is_closed: bool) {
        let next = places.iter().cycle().skip(1);
        let count = places.len() - usize::from(!is_closed);
        let lines = places.iter().zip(next).take(count);
        self.curves.extend(lines.map(|(from, to)| Curve::Line { ends: [*from, *to], radius }));
        let ends = places.iter().map(|at| Corner::End { at: *at, radius });
        self.corners.extend(ends);
    }
}
