//! Cams that cannot be followed.

use super::Words;
use crate::model::{JointId, JointKind, Origin};

impl Words<'_> {
    pub(super) fn cam_not_driven(&self, cam: JointId) -> String {
        let JointKind::Cam {
            shaft, follower, ..
        } = self.model.joint(cam).kind
        else {
            return String::new();
        };
        let (shaft, follower) = (self.joint(shaft), self.joint(follower));
        format!(
            "cam {} does not drive its follower: the coordinate of {shaft}, its shaft, is not known before that of {follower}\nhelp: \
             put a motor on {shaft} or on what moves it, or exchange the two and write the law the other way round",
            self.joint(cam)
        )
    }

    pub(super) fn cam_without_value(&self, cam: JointId, at: f64) -> (Origin, String) {
        let JointKind::Cam { shaft, law, .. } = self.model.joint(cam).kind else {
            return (self.model.origin, String::new());
        };
        let law = self.model.law(law);
        let text = format!(
            "cam {} has its follower nowhere at the start: `{}` has no value where `q`, the coordinate of {}, is {at}\nhelp: start \
             elsewhere, or change the law",
            self.joint(cam),
            law.written,
            self.joint(shaft)
        );
        (law.origin, text)
    }

    /// What to say about the start of a joint that follows a cam.
    pub(super) fn start_by_cam(&self, joint: JointId) -> Option<String> {
        let mut cams = self.model.cams();
        let (cam, shaft, ..) = cams.find(|(_, _, follower, _)| *follower == joint)?;
        Some(format!(
            "joint {} follows cam {}: where it starts is by its law\nhelp: leave this out, or start {} elsewhere",
            self.joint(joint),
            self.joint(cam),
            self.joint(shaft)
        ))
    }
}
