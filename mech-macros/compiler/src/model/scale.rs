//! The bounds on the size of a mechanism with loops: fourth powers of its lengths have to be numbers.

use super::{JointKind, Model, Precision};

/// Why a mechanism is not of a size that can be computed with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScaleTrouble {
    /// Fourth powers of its lengths are beyond the range of the scalar type.
    TooLarge,
    /// Fourth powers of its lengths are lost below the least number of the scalar type.
    TooSmall,
}

impl Precision {
    /// The least and the greatest length of a mechanism with loops.
    #[must_use]
    pub fn lengths(self) -> [f64; 2] {
        match self {
            Self::F32 => [1e-9, 1e9],
            Self::F64 => [1e-75, 1e75],
        }
    }
}

impl Model {
    /// Why its loops could not be solved, or it could not be drawn: it is too large or too small. One without any length has no size.
    #[must_use]
    pub fn scale_trouble(&self) -> Option<ScaleTrouble> {
        let holds = |kind: JointKind| {
            matches!(kind, JointKind::Revolute(..) | JointKind::Prismatic(..) | JointKind::Weld(..))
        };
        let joints = self.joints.iter().filter(|joint| holds(joint.kind));
        // A tree has one joint fewer than links.
        let has_loops = joints.count() >= self.links.len();
        let size = self.size();
        let [least, most] = self.precision.lengths();
        // Without loops squares of its lengths are enough, to draw it.
        let least = if has_loops { least } else { least * least };
        if has_loops && size > most {
            Some(ScaleTrouble::TooLarge)
        } else {
            (size > 0.0 && size < least).then_some(ScaleTrouble::TooSmall)
        }
    }
}
