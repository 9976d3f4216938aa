//! Links that welds make one body, and where they are on each other.

use crate::model::{Axis, AxisId, AxisKind, JointKind, LinkId, Model};
use petgraph::unionfind::UnionFind;

/// Places on a body that differ by no more than so many roundings are the same.
const ROUNDINGS: f64 = 64.0;

/// The bodies into which links are welded.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Welded {
    /// For each link the first of its body, and where it is on that at the start.
    on: Vec<(LinkId, Frame)>,
    /// For each link the first of those on which it keeps its place whatever the params are.
    firm: Vec<LinkId>,
}

/// Where a link is on another: the cosine and sine of its angle, and its origin.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Frame {
    direction: [f64; 2],
    origin: [f64; 2],
}

impl Frame {
    fn own() -> Self {
        Self { direction: [1.0, 0.0], origin: [0.0; 2] }
    }

    fn carry(&self, at: [f64; 2]) -> [f64; 2] {
        let [x, y] = turned(self.direction, at);
        [self.origin[0] + x, self.origin[1] + y]
    }

    fn bring_back(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let ([cos, sin], [u, v]) = (self.direction, self.origin);
        turned([cos, -sin], [x - u, y - v])
    }

    /// The frame of another link, one axis of which coincides with an axis of this link in place and direction.
    fn beyond(&self, own: &Axis, other: &Axis) -> Self {
        let back = [other.direction[0], -other.direction[1]];
        let direction = turned(turned(self.direction, own.direction), back);
        let ([x, y], [u, v]) = (self.carry(own.at), turned(direction, other.at));
        Self { direction, origin: [x - u, y - v] }
    }
}

fn turned([cos, sin]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    [cos * x - sin * y, sin * x + cos * y]
}

impl Welded {
    pub(super) fn new(model: &Model) -> Self {
        let mut beside: Vec<Vec<[AxisId; 2]>> = vec![Vec::new(); model.links.len()];
        let mut firm = UnionFind::<usize>::new(model.links.len());
        for joint in &model.joints {
            if let JointKind::Weld(a, b) = joint.kind {
                let [one, other] = [a, b].map(|axis| model.axis(axis));
                beside[one.link.index()].push([a, b]);
                beside[other.link.index()].push([b, a]);
                if !one.varies() && !other.varies() {
                    firm.union(one.link.index(), other.link.index());
                }
            }
        }
        let mut on: Vec<Option<(LinkId, Frame)>> = vec![None; model.links.len()];
        for first in model.link_ids() {
            let mut waiting = vec![(first, Frame::own())];
            while let Some((link, frame)) = waiting.pop() {
                if on[link.index()].is_none() {
                    on[link.index()] = Some((first, frame));
                    for axes in &beside[link.index()] {
                        let [own, other] = axes.map(|axis| model.axis(axis));
                        waiting.push((other.link, frame.beyond(own, other)));
                    }
                }
            }
        }
        Self {
            on: on.into_iter().flatten().collect(),
            firm: firm.into_labeling().into_iter().map(LinkId::new).collect(),
        }
    }

    /// The first link of the body that this one is part of.
    #[must_use]
    pub fn body(&self, link: LinkId) -> LinkId {
        self.on[link.index()].0
    }

    /// Where an axis is at the start, in the frame of a link of its body.
    #[must_use]
    pub fn place(&self, axis: &Axis, link: LinkId) -> [f64; 2] {
        if axis.link == link {
            return axis.at;
        }
        let [own, other] = [axis.link, link].map(|link| self.on[link.index()].1);
        other.bring_back(own.carry(axis.at))
    }

    /// Whether two links are one body.
    #[must_use]
    pub fn are_one(&self, a: LinkId, b: LinkId) -> bool {
        self.body(a) == self.body(b)
    }

    /// The axis of rotation that each point lies on, by the number of the first: points of one body that are in one place, whatever the
    /// params are.
    pub(super) fn axes(&self, model: &Model) -> UnionFind<usize> {
        let mut axes = UnionFind::new(model.axes.len());
        for joint in &model.joints {
            if let JointKind::Weld(a, b) = joint.kind {
                axes.union(a.index(), b.index());
            }
        }
        let rounding = ROUNDINGS * f64::EPSILON * model.size();
        let mut points: Vec<Vec<(usize, [f64; 2])>> = vec![Vec::new(); model.links.len()];
        for (index, axis) in model.axes.iter().enumerate() {
            if axis.kind != AxisKind::Point {
                continue;
            }
            let [x, y] = self.on[axis.link.index()].1.carry(axis.at);
            let known = &mut points[self.firm[axis.link.index()].index()];
            let same = |(other, [u, v]): &&(usize, [f64; 2])| {
                let other: &Axis = &model.axes[*other];
                // Two points of a link on one spot: a sun and an arm on the same shaft.
                let is_spot = other.link == axis.link
                    && other.at == axis.at
                    && other.formulas == axis.formulas;
                let varies = other.varies() || axis.varies();
                is_spot || !varies && (x - u).hypot(y - v) <= rounding
            };
            if let Some((first, _)) = known.iter().find(same) {
                axes.union(*first, index);
            }
            known.push((index, [x, y]));
        }
        axes
    }
}
