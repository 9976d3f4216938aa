//! The joints of a drawing: kinds, links and places.

use super::NewKind;
use super::declaration::drawn_joint;
use super::sketch::Scene;
use crate::model::{JointId, JointKind, LinkId, Model};
use std::collections::BTreeSet;

/// A joint that is drawn. Of a slot the first link has the pin.
pub(super) struct Tie {
    pub(super) kind: NewKind,
    pub(super) links: [LinkId; 2],
    pub(super) at: [f64; 2],
}

impl Tie {
    pub(super) fn has(&self, link: LinkId) -> bool {
        self.links.contains(&link)
    }

    /// The direction in which something slides.
    pub(super) fn along(&self) -> Option<[f64; 2]> {
        match self.kind {
            NewKind::Prismatic(along) | NewKind::Slot(along) => Some(along),
            NewKind::Revolute | NewKind::Weld => None,
        }
    }
}

/// All joints that are drawn, as they were declared.
pub(super) fn ties(model: &Model) -> Vec<Tie> {
    let scene = Scene::of(model);
    let tie = |joint: JointId| {
        let kind = match model.joint(joint).kind {
            JointKind::Revolute(..) => NewKind::Revolute,
            JointKind::Weld(..) => NewKind::Weld,
            JointKind::Prismatic(line, die) => {
                let along = model.axis(line).direction;
                if let Some((pin, _)) = model.link(model.axis(die).link).die {
                    let (pin, line) = (model.axis(pin), model.axis(line));
                    let is_drawn =
                        [pin, line].iter().all(|axis| axis.name.is_none() && scene.draws(axis));
                    return is_drawn.then_some(Tie {
                        kind: NewKind::Slot(along),
                        links: [pin.link, line.link],
                        at: pin.at,
                    });
                }
                NewKind::Prismatic(along)
            }
            _ => return None,
        };
        let (links, at) = drawn_joint(model, joint)?;
        Some(Tie { kind, links, at })
    };
    model.declared_joints().filter_map(tie).collect()
}

/// For each link those that a joint joins to it.
pub(super) struct Joined(Vec<BTreeSet<LinkId>>);

impl Joined {
    pub(super) fn of(model: &Model) -> Self {
        let mut joined = vec![BTreeSet::new(); model.links.len()];
        for joint in model.joint_ids() {
            let (a, b) = model.ends(joint);
            joined[a.index()].insert(b);
            joined[b.index()].insert(a);
        }
        Self(joined)
    }

    /// Whether a joint joins two links directly.
    pub(super) fn are_joined(&self, [a, b]: [LinkId; 2]) -> bool {
        self.0[a.index()].contains(&b)
    }

    /// Whether two links are joined, or both are to a third: one more joint would make a triangle that cannot move.
    pub(super) fn are_held(&self, [a, b]: [LinkId; 2]) -> bool {
        let [first, second] = [a, b].map(|link| &self.0[link.index()]);
        first.contains(&b) || !first.is_disjoint(second)
    }
}

/// The two links of a joint, as declared.
pub(super) fn both(model: &Model, joint: JointId) -> [LinkId; 2] {
    let (a, b) = model.ends(joint);
    [a.min(b), a.max(b)]
}

/// The pairs of links that would make a chain of two joints that are declared one after the other, and share no link.
pub(super) fn gaps(model: &Model) -> BTreeSet<[LinkId; 2]> {
    let chained = |joint: &JointId| {
        let kind = model.joint(*joint).kind;
        matches!(kind, JointKind::Revolute(..) | JointKind::Prismatic(..))
    };
    let joints: Vec<JointId> = model.declared_joints().filter(chained).collect();
    let mut gaps = BTreeSet::new();
    for pair in joints.windows(2) {
        let [before, after] = [pair[0], pair[1]].map(|joint| both(model, joint));
        if before.iter().all(|link| !after.contains(link)) {
            let pairs = before.iter().flat_map(|&a| after.map(|b| [a.min(b), a.max(b)]));
            gaps.extend(pairs);
        }
    }
    gaps
}
