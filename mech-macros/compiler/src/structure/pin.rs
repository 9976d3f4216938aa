//! Pins: several links on one axis of rotation (a multiple joint) are joined pairwise, whichever pairs were declared.

use crate::bug::bug;
use crate::model::{Axis, AxisId, AxisKind, JointId, JointKind, LinkId, Model};
use petgraph::unionfind::UnionFind;
use std::collections::BTreeMap;

/// An axis of rotation with all links that turn about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Pin {
    /// The links, each with its axis that lies there, in declaration order of the axes.
    pub members: Vec<(LinkId, AxisId)>,
    /// The revolute joints that were declared there.
    pub joints: Vec<JointId>,
}

impl Pin {
    /// The axis of this link on the pin, if the link is on it.
    #[must_use]
    pub fn axis_of(&self, link: LinkId) -> Option<AxisId> {
        self.members
            .iter()
            .find(|member| member.0 == link)
            .map(|member| member.1)
    }
}

/// All pins of a mechanism, in the order of their first joint.
#[must_use]
pub(super) fn pins(model: &Model) -> Vec<Pin> {
    let mut classes = UnionFind::<usize>::new(model.axes.len());
    for joint in &model.joints {
        if let JointKind::Revolute(a, b) = joint.kind {
            classes.union(a.index(), b.index());
        }
    }
    // Two points of a link on one spot are one axis: a sun and an arm on the same shaft.
    let mut on_link: BTreeMap<LinkId, Vec<usize>> = BTreeMap::new();
    for (index, axis) in model.axes.iter().enumerate() {
        if axis.kind != AxisKind::Point {
            continue;
        }
        let known = on_link.entry(axis.link).or_default();
        let same = |other: &&usize| {
            let other: &Axis = &model.axes[**other];
            other.at == axis.at && other.formulas == axis.formulas
        };
        if let Some(&first) = known.iter().find(same) {
            classes.union(first, index);
        }
        known.push(index);
    }
    let mut members: BTreeMap<usize, Vec<(LinkId, AxisId)>> = BTreeMap::new();
    for (index, axis) in model.axes.iter().enumerate() {
        let members = members.entry(classes.find(index)).or_default();
        if members.iter().all(|member| member.0 != axis.link) {
            members.push((axis.link, AxisId::new(index)));
        }
    }
    let mut place: BTreeMap<usize, usize> = BTreeMap::new();
    let mut pins: Vec<Pin> = Vec::new();
    for id in model.joint_ids() {
        if let JointKind::Revolute(a, _) = model.joint(id).kind {
            let class = classes.find(a.index());
            let pin = *place.entry(class).or_insert_with(|| {
                let Some(members) = members.remove(&class) else {
                    bug!("a pin has no axes");
                };
                pins.push(Pin {
                    members,
                    joints: Vec::new(),
                });
                pins.len() - 1
            });
            pins[pin].joints.push(id);
        }
    }
    pins
}
