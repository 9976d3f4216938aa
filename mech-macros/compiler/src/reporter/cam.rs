//! Cams that cannot be followed.

use super::Words;
use super::wording::brief;
use crate::model::{JointId, JointKind, Origin};

impl Words<'_> {
    pub(super) fn cam_not_driven(&self, cam: JointId) -> String {
        let JointKind::Cam { shaft, follower, .. } = self.model.joint(cam).kind else {
            return String::new();
        };
        let (shaft, follower) = (self.joint(shaft), self.joint(follower));
        format!(
            "cam {} does not drive its follower: the coordinate of {shaft}, its shaft, is not known before that of {follower}\nhelp: \
             put a motor on {shaft} or on what moves it, or exchange shaft and follower, and invert the law",
            self.joint(cam)
        )
    }

    pub(super) fn cam_without_value(&self, cam: JointId, at: f64) -> (Origin, String) {
        let JointKind::Cam { shaft, law, .. } = self.model.joint(cam).kind else {
            return (self.model.origin, String::new());
        };
        let law = self.model.law(law);
        let text = format!(
            "cam {} gives its follower no place at the start: `{}` has no value where `q`, the coordinate of {}, is {at}\nhelp: start \
             elsewhere, or change the law",
            self.joint(cam),
            law.written,
            self.joint(shaft)
        );
        (law.origin, text)
    }

    /// Returns the message about a cam whose law does not begin where its follower is drawn, if there is one.
    pub(super) fn cam_off_the_drawing(&self) -> Option<(Origin, String)> {
        const SLACK: f64 = 1e-7;
        let (cam, follower, law, value) =
            self.model.cams().find_map(|(cam, shaft, follower, law)| {
                let is_known = self.is_drawn(shaft) || self.model.motor_of(shaft).is_some();
                let value = self.model.at_start(law, self.model.start.value(shaft));
                (is_known && self.is_drawn(follower) && value.abs() > SLACK)
                    .then_some((cam, follower, law, value))
            })?;
        let (sign, size) = if value < 0.0 { ('+', -value) } else { ('-', value) };
        let (_, link) = self.model.ends(follower);
        let change = if law.is_motion() {
            "let the motion begin elsewhere, by `from`".to_owned()
        } else {
            format!("write `{} {sign} {size}`", law.written)
        };
        let text = format!(
            "cam {} gives its follower {} at the start, but the coordinate of {} is 0 where it is drawn\nhelp: draw {} as it is at the \
             start, and {change}",
            self.joint(cam),
            brief(value),
            self.joint(follower),
            self.link(link),
        );
        Some((law.origin, text))
    }

    /// Returns the message about the start of a joint that follows a cam.
    pub(super) fn start_by_cam(&self, joint: JointId) -> Option<String> {
        let mut cams = self.model.cams();
        let (cam, shaft, ..) = cams.find(|(_, _, follower, _)| *follower == joint)?;
        Some(format!(
            "joint {} follows cam {}, whose law gives its start\nhelp: leave this out, or start {} elsewhere",
            self.joint(joint),
            self.joint(cam),
            self.joint(shaft)
        ))
    }
}
