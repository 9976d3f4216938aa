//! Which links joints join directly.

use crate::model::{LinkId, Model};
use std::collections::BTreeSet;

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
