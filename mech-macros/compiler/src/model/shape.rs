//! Shapes: what is seen of a link.

use super::{Figure, FormulaId, Origin};

/// A coloured spot that belongs to one plane for ever.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Shape {
    /// Where it was declared.
    pub origin: Origin,
    /// Its outline, in the frame of the link.
    pub kind: ShapeKind,
    /// The plane it lies in: greater is nearer to the eye.
    pub plane: i32,
    /// Its entry in the palette.
    pub color: u8,
    /// The formulas of those of its [`numbers`](ShapeKind::numbers) that depend on params.
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
        /// Its width, greater than zero.
        width: f64,
    },
    /// A filled simple polygon of at least three corners.
    Polygon(Vec<[f64; 2]>),
    /// A figure: it depends on no param, and lengths and directions that are not given follow from the mechanism.
    Figure(Figure),
}

/// The quality of a picture that a mechanism makes for itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Quality {
    /// A pixel belongs to a shape or does not: a `Frame`.
    #[default]
    Hard,
    /// Edges are anti-aliased: a `Smooth`.
    Smooth,
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

/// A number of what is drawn: a share of another, which may depend on params.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Measure {
    /// The number of which it is a share, at the start.
    pub value: f64,
    /// The formula of that number, if it depends on params.
    pub formula: Option<FormulaId>,
    /// The share.
    pub share: f64,
}

/// A place in the frame of a link, in scene units.
pub type Place = [Measure; 2];

impl Measure {
    /// A number that does not change.
    pub(crate) fn fixed(value: f64) -> Self {
        Self::new(value, None)
    }

    /// A number that may depend on params.
    pub(crate) fn new(value: f64, formula: Option<FormulaId>) -> Self {
        let share = 1.0;
        Self { value, formula, share }
    }

    /// So many times this number.
    pub(crate) fn times(self, share: f64) -> Self {
        let share = self.share * share;
        Self { share, ..self }
    }

    /// The number at the start.
    #[must_use]
    pub fn at_start(self) -> f64 {
        self.share * self.value
    }
}
