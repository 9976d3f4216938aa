//! Joints and motors.

use super::{AxisId, JointId, LinkId, Origin};

/// A joint between two links.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Its name.
    pub name: String,
    /// Where its name was declared.
    pub origin: Origin,
    /// What it joins, and how.
    pub kind: JointKind,
}

/// The kinds of joint. The coordinate of a joint is that of its second part relative to its first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointKind {
    /// Two point axes coincide; the coordinate is the angle from the first's direction to the second's, in radians.
    Revolute(AxisId, AxisId),
    /// Two line axes coincide; the coordinate is the way from the first's origin to the second's, along the line.
    Prismatic(AxisId, AxisId),
    /// Two toothed wheels roll on each other.
    Gear {
        /// The first wheel.
        a: LinkId,
        /// The second wheel.
        b: LinkId,
        /// The sizes of the two.
        ratio: Ratio,
    },
}

/// The sizes of two meshing wheels. One of them is negative for an internal gear (a ring); none is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ratio {
    /// Numbers of teeth: exact.
    Teeth(i64, i64),
    /// Pitch radii, in scene units.
    Radii(f64, f64),
}

impl Ratio {
    /// How fast the second wheel turns for one turn of the first, both seen from their carrier: −a / b.
    #[must_use]
    #[expect(
        clippy::cast_precision_loss,
        reason = "a wheel of 2^53 teeth does not exist"
    )]
    pub fn speed(self) -> f64 {
        match self {
            Self::Teeth(a, b) => -(a as f64) / b as f64,
            Self::Radii(a, b) => -a / b,
        }
    }
}

/// A motor: the coordinate of its joint is given from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motor {
    /// The joint it drives: revolute or prismatic.
    pub joint: JointId,
    /// Where it was declared.
    pub origin: Origin,
}
