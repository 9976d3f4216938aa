//! Links, and what is rigidly fixed to them.

use super::{AxisId, FormulaId, LinkId, Mass, Measure, Origin, Place, Shape};
use crate::bug::bug;

/// A rigid body that moves in planes parallel to the screen.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Link {
    /// Its name.
    pub name: String,
    /// Where its name was declared.
    pub origin: Origin,
    /// Whether its frame is the scene's at the start, because joints were placed on it in the drawing (`at`).
    pub drawn: bool,
    /// The shapes that are seen of it.
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// The formulas of those coordinates of its origin that depend on params.
    pub formulas: [Option<FormulaId>; 2],
    /// Its direction, of length one, in the frame of the link: at the start, if it depends on params.
    pub direction: [f64; 2],
    /// The formulas of both parts of its direction, if that depends on params: a line's may.
    pub direction_formulas: [Option<FormulaId>; 2],
}

impl Axis {
    /// Its origin in the frame of its link.
    #[must_use]
    pub fn place(&self) -> Place {
        [0, 1].map(|part| Measure::new(self.at[part], self.formulas[part]))
    }

    /// Both parts of its direction.
    pub(crate) fn along(&self) -> [Measure; 2] {
        [0, 1].map(|part| Measure::new(self.direction[part], self.direction_formulas[part]))
    }

    /// Its name, where only what has one is spoken of.
    pub(crate) fn own_name(&self) -> &str {
        let Some(name) = &self.name else {
            bug!("an axis without a name is spoken of by its name");
        };
        name
    }
}

/// The kind of an axis: the motion that it allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum AxisKind {
    /// Rotation about it.
    Point,
    /// Sliding along it.
    Line,
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

/// An instance of a part. What belongs to it has names that begin with its path.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Instance {
    /// The name of the use.
    pub name: String,
    /// Its number among the instances of the use, if that has several.
    pub index: Option<usize>,
    /// The name of the part.
    pub part: String,
    /// The path to it: `left[2]`.
    pub path: String,
    /// The instance that uses it; none if the mechanism itself does.
    pub parent: Option<usize>,
}
