//! Links, and what is rigidly fixed to them.

use super::{AxisId, Figure, FormulaId, LinkId, Mass, Origin};
use crate::bug::bug;

/// A rigid body that moves in planes parallel to the screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// Its name.
    pub name: String,
    /// Where its name was declared.
    pub origin: Origin,
    /// Whether its frame is the scene's at the start, because joints were placed on it in the drawing (`at`).
    pub drawn: bool,
    /// What is seen of it.
    pub shapes: Vec<Shape>,
    /// Its mass, if it has any.
    pub mass: Option<Mass>,
    /// If it is the die of a slot, which nobody declared: the point axis on whose pin it turns and the line axis in which it
    /// slides. Dies come after all other links.
    pub die: Option<(AxisId, AxisId)>,
}

impl Link {
    /// A link that nothing is fixed to yet.
    #[must_use]
    pub fn new(name: &str, origin: Origin) -> Self {
        Self {
            name: name.to_owned(),
            origin,
            drawn: false,
            shapes: Vec::new(),
            mass: None,
            die: None,
        }
    }
}

/// An axis of rotation (a point with a direction) or of sliding (a line with an origin), fixed to a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The link to which it is fixed.
    pub link: LinkId,
    /// Its name in that link; an axis made by a joint placed in the drawing has none.
    pub name: Option<String>,
    /// The path of the port, `left[2].frame`, if a part fixed it to a link that it was lent.
    pub port: Option<String>,
    /// Where its name was declared, or the joint that made it.
    pub origin: Origin,
    /// Rotation or sliding.
    pub kind: AxisKind,
    /// Its origin, in the frame of the link: at the start, if it depends on params.
    pub at: [f64; 2],
    /// How each coordinate of its origin is computed that depends on params.
    pub formulas: [Option<FormulaId>; 2],
    /// Its direction, of length one, in the frame of the link: at the start, if it depends on params.
    pub direction: [f64; 2],
    /// How both parts of its direction are computed, if that depends on params: a line's may.
    pub direction_formulas: [Option<FormulaId>; 2],
}

impl Axis {
    /// Its name, where only what has one is spoken of.
    pub(crate) fn own_name(&self) -> &str {
        let Some(name) = &self.name else {
            bug!("an axis without a name is spoken of by its name");
        };
        name
    }
}

/// What an axis allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisKind {
    /// Rotation about it.
    Point,
    /// Sliding along it.
    Line,
}

/// A coloured spot that belongs to one plane for ever.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Where it was declared.
    pub origin: Origin,
    /// Its outline, in the frame of the link.
    pub kind: ShapeKind,
    /// The plane it lies in: greater is nearer to the eye.
    pub plane: i32,
    /// Its entry in the palette.
    pub color: u8,
    /// How each of its [`numbers`](ShapeKind::numbers) is computed that depends on params.
    pub formulas: Vec<Option<FormulaId>>,
}

impl Shape {
    /// Whether it depends on a param.
    #[must_use]
    pub fn varies(&self) -> bool {
        self.formulas.iter().any(Option::is_some)
    }
}

/// The outline of a shape.
#[derive(Clone, Debug, PartialEq)]
pub enum ShapeKind {
    /// A filled circle.
    Circle {
        /// Its centre.
        center: [f64; 2],
        /// Its radius, greater than zero.
        radius: f64,
    },
    /// A circle with a hole of the same centre.
    Ring {
        /// Its centre.
        center: [f64; 2],
        /// Its radius.
        radius: f64,
        /// The radius of its hole, less than that and greater than zero.
        hole: f64,
    },
    /// A bar with round ends and an eye at each of its pins, of which there are at least two.
    Bar {
        /// Where it leads through.
        pins: Vec<[f64; 2]>,
        /// How wide it is, greater than zero.
        width: f64,
    },
    /// A filled simple polygon of at least three corners.
    Polygon(Vec<[f64; 2]>),
    /// What depends on no param, and of which lengths and directions that are not given follow from the mechanism.
    Figure(Figure),
}

/// What a picture looks like that a mechanism makes for itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Quality {
    /// A pixel belongs to a shape or does not: a `Frame`.
    #[default]
    Hard,
    /// Edges are anti-aliased: a `Smooth`.
    Smooth,
}

impl Link {
    /// Points of its shapes, each with how far the shape reaches around it.
    pub(crate) fn shape_points(&self) -> impl Iterator<Item = ([f64; 2], f64)> {
        self.shapes.iter().flat_map(|shape| {
            let (points, radius) = shape.kind.reach();
            points.iter().map(move |&point| (point, radius))
        })
    }
}

impl ShapeKind {
    /// Some of its points, and how far it reaches around them.
    #[must_use]
    pub fn reach(&self) -> (&[[f64; 2]], f64) {
        match self {
            Self::Circle { center, radius } | Self::Ring { center, radius, .. } => {
                (std::slice::from_ref(center), *radius)
            }
            Self::Bar { pins, width } => (pins, width / 2.0),
            Self::Polygon(corners) => (corners, 0.0),
            Self::Figure(figure) => figure.reach(),
        }
    }

    /// All numbers that it is made of: both coordinates of each point, then its lengths.
    #[must_use]
    pub fn numbers(&self) -> Vec<f64> {
        let (points, _) = self.reach();
        let lengths = match *self {
            Self::Circle { radius, .. } => vec![radius],
            Self::Ring { radius, hole, .. } => vec![radius, hole],
            Self::Bar { width, .. } => vec![width],
            Self::Polygon(_) => Vec::new(),
            Self::Figure(_) => return Vec::new(),
        };
        points.iter().flatten().copied().chain(lengths).collect()
    }
}
