//! Coordinates of joints that a position carries over any number of turns.

use super::Program;
use crate::model::JointId;

/// The coordinate of a joint that a position carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JointAngle {
    /// The joint.
    pub joint: JointId,
    /// Where its coordinate is kept.
    pub state: usize,
}

impl Program {
    /// Where the coordinate of a joint is kept; none if no position carries it.
    #[must_use]
    pub fn angle_state(&self, joint: JointId) -> Option<usize> {
        let mut angles = self.joint_angles.iter();
        let found = angles.find(|angle| angle.joint == joint);
        found.map(|angle| angle.state)
    }
}
