//! Pins: several links on one axis of rotation (a multiple joint) are joined pairwise, whichever pairs were declared.

use crate::model::{Axis, AxisId, AxisKind, JointId, JointKind, LinkId, Model};
use petgraph::unionfind::UnionFind;

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
    for (index, axis) in model.axes.iter().enumerate() {
        let same = |other: &Axis| {
            let point = axis.kind == AxisKind::Point && other.kind == AxisKind::Point;
            point
                && other.link == axis.link
                && other.at == axis.at
                && other.formulas == axis.formulas
        };
        if let Some(first) = model.axes[..index].iter().position(same) {
            classes.union(first, index);
        }
    }
    let mut pins: Vec<(usize, Pin)> = Vec::new();
    for id in model.joint_ids() {
        if let JointKind::Revolute(a, _) = model.joint(id).kind {
            let class = classes.find(a.index());
            match pins.iter_mut().find(|(known, _)| *known == class) {
                Some((_, pin)) => pin.joints.push(id),
                None => pins.push((
                    class,
                    Pin {
                        members: members(model, &classes, class),
                        joints: vec![id],
                    },
                )),
            }
        }
    }
    pins.into_iter().map(|(_, pin)| pin).collect()
}

fn members(model: &Model, classes: &UnionFind<usize>, class: usize) -> Vec<(LinkId, AxisId)> {
    let mut members: Vec<(LinkId, AxisId)> = Vec::new();
    for (index, axis) in model.axes.iter().enumerate() {
        if classes.find(index) == class && members.iter().all(|member| member.0 != axis.link) {
            members.push((axis.link, AxisId::new(index)));
        }
    }
    members
}
