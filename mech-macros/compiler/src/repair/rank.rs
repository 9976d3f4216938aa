//! The order in which changes are offered.

use super::{Declaration, NewKind, Purpose, Repair};
use crate::model::{JointId, LinkId, Model};
use crate::structure::{self, Diagnosis, Pin};

/// Ranks the changes that mend the same: the least comes first.
pub(super) struct Ranking<'m> {
    model: &'m Model,
    pins: Vec<Pin>,
    /// Whether links may be there that nobody has joined yet.
    incomplete: bool,
}

impl<'m> Ranking<'m> {
    pub(super) fn new(model: &'m Model, of: &Diagnosis) -> Self {
        Self {
            model,
            pins: structure::pins(model),
            incomplete: matches!(of, Diagnosis::Loose { .. }),
        }
    }

    /// Returns the rank of a repair: those that the drawing suggests come first, then one kind after the other, each as declared.
    pub(super) fn of(&self, repair: &Repair) -> (usize, usize) {
        match repair {
            Repair::Declare(Declaration { purpose, .. }) => match purpose {
                Purpose::Ground | Purpose::Slide | Purpose::Join { .. } => (0, 0),
                Purpose::Fix | Purpose::Meet => (0, 1),
                Purpose::Turn | Purpose::Guide | Purpose::Free => (3, 0),
                Purpose::Connect => (9, 0),
                Purpose::Stiffen => (10, 0),
            },
            Repair::RemoveJoint(joint) if self.is_copy(*joint) => (0, 2),
            Repair::RemoveLink(link) if self.incomplete => (1, link.index()),
            Repair::RemoveLink(link) if self.is_brace(*link) => (2, link.index()),
            Repair::RemoveJoint(joint) if self.pins_again(*joint) => (4, joint.index()),
            Repair::RemoveLink(link) => (5, link.index()),
            Repair::RemoveJoint(joint) => (6, joint.index()),
            Repair::Replace {
                joint,
                by: NewKind::Slot(_),
            } => (7, joint.index()),
            Repair::Replace { joint, .. } => (8, joint.index()),
            _ => (1, 0),
        }
    }

    /// The same of two changes that are enough together: those that the drawing suggests come first.
    pub(super) fn of_pair(&self, pair: &[Repair; 2]) -> usize {
        let suggested = |repair: &&Repair| self.of(repair).0 == 0;
        2 - pair.iter().filter(suggested).count()
    }

    /// Whether all joints of a link, two at least, are on pins that others share: without it nothing hangs loose.
    fn is_brace(&self, link: LinkId) -> bool {
        let joints = self.model.joint_ids().filter(|&joint| {
            let (a, b) = self.model.ends(joint);
            a == link || b == link
        });
        let shared: Vec<bool> = joints.map(|joint| self.is_shared(joint)).collect();
        shared.len() > 1 && shared.iter().all(|shared| *shared)
    }

    /// Whether a joint pins to the ground what would be joined to something else without it.
    fn pins_again(&self, joint: JointId) -> bool {
        let (a, b) = self.model.ends(joint);
        (a == LinkId::GROUND || b == LinkId::GROUND) && self.is_shared(joint)
    }

    /// Whether a joint pins the same links together as one that was declared before it.
    fn is_copy(&self, joint: JointId) -> bool {
        let ends = |joint: JointId| {
            let (a, b) = self.model.ends(joint);
            (a.min(b), a.max(b))
        };
        let mut pins = self.pins.iter();
        let pin = pins.find(|pin| pin.joints.contains(&joint));
        let mut others = pin.into_iter().flat_map(|pin| &pin.joints);
        others.any(|&other| other < joint && ends(other) == ends(joint))
    }

    /// Whether more than two links turn on the pin of a joint.
    fn is_shared(&self, joint: JointId) -> bool {
        let mut pins = self.pins.iter();
        pins.any(|pin| pin.joints.contains(&joint) && pin.members.len() > 2)
    }
}
