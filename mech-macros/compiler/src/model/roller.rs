//! Rollers: the points of followers that run on cams.

use super::{AxisId, JointId, JointKind, LinkId, Model, Origin};

/// The roller of a cam's follower.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Roller {
    /// The cam.
    pub cam: JointId,
    /// Its middle: a point of the follower.
    pub point: AxisId,
    /// Its radius, in scene units: greater than zero.
    pub radius: f64,
    /// Where it was declared.
    pub origin: Origin,
}

impl Model {
    /// The roller of a cam, if it was declared.
    #[must_use]
    pub fn roller_of(&self, cam: JointId) -> Option<&Roller> {
        self.rollers.iter().find(|roller| roller.cam == cam)
    }

    /// The axes that place a cam and its roller.
    #[must_use]
    pub fn axes_of_contact(&self, cam: JointId) -> Vec<AxisId> {
        let mut axes: Vec<AxisId> =
            self.roller_of(cam).map(|roller| roller.point).into_iter().collect();
        if let JointKind::Cam { shaft, follower, .. } = self.joint(cam).kind {
            let joints = [shaft, follower].into_iter();
            axes.extend(joints.filter_map(|joint| self.joint(joint).kind.axes()).flatten());
        }
        axes
    }

    /// Of the axes of a joint, the one that is not on its carrier. With it 1 if the joint is declared from the carrier, else −1.
    #[must_use]
    pub fn beside(&self, joint: JointId, carrier: LinkId) -> Option<(AxisId, f64)> {
        let (JointKind::Revolute(a, b) | JointKind::Prismatic(a, b)) = self.joint(joint).kind
        else {
            return None;
        };
        Some(if self.axis(a).link == carrier { (b, 1.0) } else { (a, -1.0) })
    }
}
