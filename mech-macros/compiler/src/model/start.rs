//! Where a mechanism is assembled.

use super::{JointId, LinkId, Origin};

/// The start of the motion.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Start {
    /// Coordinates of joints; a motor that is not listed starts at zero.
    pub values: Vec<StartValue>,
    /// Which of several assemblies is meant.
    pub near: Vec<Near>,
    /// Coordinates that are known beforehand: those of joints whose start is open are taken.
    pub known: Vec<StartValue>,
}

impl Start {
    /// The coordinate of a joint at the start, as far as it was said or is known: zero if it is not listed.
    #[must_use]
    pub fn value(&self, joint: JointId) -> f64 {
        let mut listed = self.values.iter().chain(&self.known);
        listed.find(|value| value.joint == joint).map_or(0.0, |value| value.value)
    }
}

/// A joint's coordinate at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StartValue {
    /// The joint: one with a motor, or one that a gear drives.
    pub joint: JointId,
    /// Its coordinate, in radians or scene units.
    pub value: f64,
    /// Where it was declared.
    pub origin: Origin,
}

/// Of several assemblies, take the one in which this link's direction in the scene is nearest to this angle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Near {
    /// The link.
    pub link: LinkId,
    /// The angle of its frame in the scene, in radians.
    pub angle: f64,
    /// Where it was declared.
    pub origin: Origin,
}
