//! The layout of the numbers in a position's state.

use super::Program;
use crate::model::{FormulaId, JointId};

/// The places in the state of all numbers that have a meaning outside of the loops.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StateLayout {
    /// The first of the signs of the inputs' last motions, if a loop passes change points: one number for each motor and
    /// param. After them comes one for each watched loop: that of its `mech_core::journey::Standing`.
    pub motion_signs: Option<usize>,
    /// The coordinates of joints over any number of turns, where they are asked for or torsional springs need them.
    pub joint_angles: Vec<JointAngle>,
    /// Numbers of axes and shapes that depend on params.
    pub places: Vec<Place>,
}

/// The coordinate of a joint, over any number of turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct JointAngle {
    /// The joint.
    pub joint: JointId,
    /// The index in the state.
    pub state: usize,
}

/// A number that depends on params: of the place or direction of an axis in its link, or of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Place {
    /// The formula that computes it.
    pub formula: FormulaId,
    /// The index in the state.
    pub state: usize,
}

impl Program {
    /// The index in the state of a joint's coordinate; none if no position carries it.
    #[must_use]
    pub fn angle_state(&self, joint: JointId) -> Option<usize> {
        let mut angles = self.layout.joint_angles.iter();
        let found = angles.find(|angle| angle.joint == joint);
        found.map(|angle| angle.state)
    }

    /// The index in the state of what a formula of params gives; none if it is not exposed.
    #[must_use]
    pub fn formula_state(&self, formula: FormulaId) -> Option<usize> {
        let mut places = self.layout.places.iter();
        let found = places.find(|place| place.formula == formula);
        found.map(|place| place.state)
    }
}
