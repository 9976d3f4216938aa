//! Coordinates that go on over whole turns.

use super::Lowering;
use crate::model::{JointId, JointKind};
use crate::syntax::ast::Name;
use proc_macro2::Span;

impl Lowering {
    pub(super) fn lower_continuous(&mut self, keyword: Span, joints: &[Name]) {
        self.single(keyword, "continuous", "put all joints into the first");
        for name in joints {
            self.report.next_item();
            let Some(joint) = self.find_joint(name) else {
                continue;
            };
            if let Some(text) = self.cannot_go_on(name, joint) {
                self.report.error(name.place(), text);
            } else {
                self.model.continuous.push(joint);
            }
        }
        self.report.next_item();
    }

    /// What to say about a joint whose coordinate cannot go on over whole turns, or does already. A motor may be on it: what it is
    /// given goes on, too, and the motor may be moved.
    fn cannot_go_on(&self, name: &Name, joint: JointId) -> Option<String> {
        if let Some(text) = self.no_coordinate(name, joint, "ask for") {
            return Some(text);
        }
        if let JointKind::Prismatic(..) = self.model.joint(joint).kind {
            return Some(format!(
                "joint `{name}` slides: its coordinate has no turns; leave this out"
            ));
        }
        if self.model.continuous.contains(&joint) {
            return Some(format!(
                "`{name}` is continuous already; remove one of the two"
            ));
        }
        (!self.model.shows_joint(joint)).then(|| {
            format!("`show` leaves the coordinate of `{name}` out; add it there, or leave this out")
        })
    }
}
