//! Pins: several links on one axis of rotation (a multiple joint) are joined pairwise, whichever pairs were declared. Welded links share
//! their axes.

use super::welded::Welded;
use crate::bug::bug;
use crate::model::{AxisId, JointId, JointKind, LinkId, Model};
use std::collections::BTreeMap;

/// An axis of rotation with all links that turn about it.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pin {
    /// The links, each with its axis that lies there, in declaration order of the axes.
    pub members: Vec<(LinkId, AxisId)>,
    /// The revolute joints that were declared there.
    pub joints: Vec<JointId>,
}

impl Pin {
    /// The axis on the pin of the body that this link is part of: the link's own, if it has one there.
    #[must_use]
    pub fn axis_of_body(&self, welded: &Welded, link: LinkId) -> Option<AxisId> {
        let mut members = self.members.iter();
        let body = members.find(|member| welded.are_one(member.0, link));
        self.axis_of(link).or(body.map(|member| member.1))
    }

    /// The axis of this link on the pin, if the link is on it.
    #[must_use]
    pub fn axis_of(&self, link: LinkId) -> Option<AxisId> {
        self.members.iter().find(|member| member.0 == link).map(|member| member.1)
    }
}

/// All pins of a mechanism, in the order of their first joint.
#[must_use]
pub(super) fn pins(model: &Model, welded: &Welded) -> Vec<Pin> {
    let mut classes = welded.axes(model);
    for joint in &model.joints {
        if let JointKind::Revolute(a, b) = joint.kind {
            classes.union(a.index(), b.index());
        }
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
                pins.push(Pin { members, joints: Vec::new() });
                pins.len() - 1
            });
            pins[pin].joints.push(id);
        }
    }
    pins
}

/// The pin on which a wheel turns on its carrier. If there is none, a pin that joins a link welded to the wheel with a link welded to the
/// carrier.
pub(super) fn shaft<'p>(
    pins: &'p [Pin],
    welded: &Welded,
    wheel: LinkId,
    carrier: LinkId,
) -> Option<&'p Pin> {
    let links = [wheel, carrier];
    let own = |pin: &&Pin| links.iter().all(|link| pin.axis_of(*link).is_some());
    let of_bodies = |pin: &&Pin| {
        let mut links = links.iter();
        links.all(|link| pin.axis_of_body(welded, *link).is_some())
    };
    pins.iter().find(own).or_else(|| pins.iter().find(of_bodies))
}

/// The axes of a wheel and of its carrier there.
pub(super) fn hub(
    pins: &[Pin],
    welded: &Welded,
    wheel: LinkId,
    carrier: LinkId,
) -> Option<[AxisId; 2]> {
    let pin = shaft(pins, welded, wheel, carrier)?;
    let [own, other] = [wheel, carrier].map(|link| pin.axis_of_body(welded, link));
    Some([own?, other?])
}
