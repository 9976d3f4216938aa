//! What the numbers of a position's state are.

use super::Program;
use crate::model::{AxisId, JointId};

/// Where in the state each number stands that has a meaning outside of the loops.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StateLayout {
    /// The first of the signs of the inputs' last motions, if a loop passes change points: one number for each motor and param.
    pub motion_signs: Option<usize>,
    /// The coordinates of joints over any number of turns, where they are asked for or torsional springs need them.
    pub joint_angles: Vec<JointAngle>,
    /// The coordinates of axes in their links that depend on params.
    pub places: Vec<Place>,
}

/// The coordinate of a joint, over any number of turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JointAngle {
    /// The joint.
    pub joint: JointId,
    /// The index in the state.
    pub state: usize,
}

/// A coordinate of an axis in its link that depends on params.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The axis.
    pub axis: AxisId,
    /// Which of its coordinates: zero for the abscissa, one for the ordinate.
    pub part: usize,
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

    /// The index in the state of an axis's coordinate in its link; none if it is a constant, or not exposed.
    #[must_use]
    pub fn place_state(&self, axis: AxisId, part: usize) -> Option<usize> {
        let found = |place: &&Place| place.axis == axis && place.part == part;
        self.layout
            .places
            .iter()
            .find(found)
            .map(|place| place.state)
    }
}
