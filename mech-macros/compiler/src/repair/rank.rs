//! The order in which changes are offered.

use super::guides::is_slider;
use super::sketch::leaves;
use super::tie::gaps;
use super::{Declaration, NewKind, Purpose, Repair};
use crate::model::{JointId, JointKind, LinkId, Model};
use crate::structure::{self, Diagnosis, KinematicGraph, Pin};
use std::collections::BTreeSet;

/// What was declared last is the likelier slip.
fn last_first(index: usize) -> usize {
    usize::MAX - index
}

/// Whether two links would be joined where one of them ends.
fn is_at_end(repair: &Repair) -> bool {
    matches!(repair, Repair::Declare(Declaration { purpose: Purpose::Join { .. }, .. }))
}

/// Ranks the changes that mend the same: the least comes first.
pub(super) struct Ranking<'m> {
    model: &'m Model,
    pins: Vec<Pin>,
    gaps: BTreeSet<[LinkId; 2]>,
    leaves: Vec<(LinkId, JointId)>,
    /// Whether links may be there that nobody has joined yet.
    incomplete: bool,
    /// Whether no joint belongs to a loop.
    is_open: bool,
}

impl<'m> Ranking<'m> {
    pub(super) fn new(model: &'m Model, of: &Diagnosis) -> Self {
        Self {
            model,
            pins: structure::pins(model),
            gaps: gaps(model),
            leaves: leaves(model),
            incomplete: matches!(of, Diagnosis::Loose { .. }),
            is_open: KinematicGraph::new(model).arms().len() == model.joints.len(),
        }
    }

    /// Returns the rank of a repair: those that the drawing suggests come first, then one kind after the other, each as declared.
    pub(super) fn of(&self, repair: &Repair) -> (usize, usize) {
        match repair {
            Repair::Declare(declared) => match declared.purpose {
                Purpose::Twin => (0, 0),
                Purpose::Meet if self.joins_leaves(declared) => (0, 0),
                Purpose::Slide | Purpose::Guess if self.is_slider(declared) => (0, 1),
                Purpose::Join { .. } => (0, 1),
                Purpose::Ground if self.is_in_gap(declared) => (0, 1),
                Purpose::Meet if self.is_in_gap(declared) => (0, 2),
                Purpose::Ground | Purpose::Slide => (0, 2),
                Purpose::Fix | Purpose::Meet | Purpose::Guess => (0, 3),
                Purpose::Turn | Purpose::Guide | Purpose::Free => (3, 1),
                Purpose::Split => (8, 0),
                Purpose::Connect => (9, 0),
                Purpose::Stiffen => (10, 0),
            },
            Repair::RemoveJoint(joint) if self.is_copy(*joint) => (0, 4),
            Repair::RemoveLink(link) if self.incomplete => (1, link.index()),
            Repair::Replace { by: NewKind::Revolute, joint } => (2, last_first(joint.index())),
            // Where it is enough that a joint goes, no link has to.
            Repair::RemoveJoint(joint) if self.pins_again(*joint) => (4, last_first(joint.index())),
            Repair::RemoveJoint(joint) => (5, last_first(joint.index())),
            Repair::RemoveLink(link) if self.is_brace(*link) => (6, last_first(link.index())),
            Repair::RemoveLink(link) => (7, last_first(link.index())),
            Repair::Replace { joint, .. } => (8, last_first(joint.index())),
            _ => (1, 0),
        }
    }

    /// Puts them in this order. Second comes what a drawing often means: behind a motor that may be missing a knee of a bent link, or a link
    /// that moves what hangs loose; behind a link that may be too many the halves of another.
    pub(super) fn sort(&self, repairs: &mut [Repair]) {
        repairs.sort_by_key(|repair| self.of(repair));
        let likely = match repairs.first() {
            Some(Repair::AddMotors(_)) => repairs.iter().position(|one| self.is_often_meant(one)),
            Some(Repair::RemoveLink(_)) => repairs.iter().position(|one| {
                matches!(one, Repair::Declare(Declaration { purpose: Purpose::Split, .. }))
            }),
            // Two ends may be tips.
            Some(first) if is_at_end(first) && repairs.get(1).is_some_and(is_at_end) => {
                repairs.iter().position(|one| !is_at_end(one) && self.of(one) <= (0, 2))
            }
            _ => None,
        };
        if let Some(likely) = likely {
            repairs[1..=likely].rotate_right(1);
        }
    }

    fn is_often_meant(&self, repair: &Repair) -> bool {
        let Repair::Declare(declared) = repair else {
            return false;
        };
        let leaves = &self.leaves;
        let slides =
            |joint: JointId| matches!(self.model.joint(joint).kind, JointKind::Prismatic(..));
        match declared.purpose {
            Purpose::Stiffen => {
                let mut joints = leaves.iter().map(|leaf| leaf.1);
                joints.all(|joint| !declared.replaced.contains(&joint))
            }
            Purpose::Connect => {
                let mut ends =
                    declared.joints.iter().flat_map(|joint| joint.ends.links(self.model));
                self.is_open
                    || ends.any(|end| leaves.iter().any(|leaf| leaf.0 == end && slides(leaf.1)))
            }
            _ => false,
        }
    }

    /// The same of two changes that are enough together: those that the drawing suggests come first.
    pub(super) fn of_pair(&self, pair: &[Repair; 2]) -> usize {
        let suggested = |repair: &&Repair| self.of(repair).0 == 0;
        2 - pair.iter().filter(suggested).count()
    }

    /// Whether a new joint is between two links each of which hangs on another.
    fn joins_leaves(&self, declared: &Declaration) -> bool {
        let mut joints = declared.joints.iter();
        joints.all(|joint| {
            let mut ends = joint.ends.links(self.model).into_iter();
            ends.all(|end| self.leaves.iter().any(|leaf| leaf.0 == end))
        })
    }

    /// Whether the name of what would slide says so.
    fn is_slider(&self, declared: &Declaration) -> bool {
        let mut joints = declared.joints.iter();
        joints.any(|joint| {
            let mut ends = joint.ends.links(self.model).into_iter();
            ends.any(|end| is_slider(self.model, end))
        })
    }

    /// Whether a new joint is where the list of joints reads as a chain that comes apart.
    fn is_in_gap(&self, declared: &Declaration) -> bool {
        let mut joints = declared.joints.iter();
        joints.any(|joint| {
            let [a, b] = joint.ends.links(self.model);
            self.gaps.contains(&[a.min(b), a.max(b)])
        })
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
