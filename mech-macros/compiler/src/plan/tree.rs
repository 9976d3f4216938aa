//! The tree of a cluster's links: its edges are the joints by which the parts were brought together, its root is the base.

use super::step::Connection;
use crate::model::{AxisId, LinkId};

/// A connection that brought two clusters together, and how far it slides.
#[derive(Clone, Copy, Debug)]
pub(super) struct Joining<S> {
    pub(super) connection: Connection,
    pub(super) displacement: Option<S>,
}

/// The edge of the tree by which a link hangs on another.
#[derive(Clone, Copy, Debug)]
struct Hold<S> {
    on: LinkId,
    joining: Joining<S>,
    /// Whether the connection leads from the link to what it hangs on.
    upwards: bool,
}

impl<S: Copy> Hold<S> {
    /// The axis of the link, and that of what it hangs on.
    fn axes(&self) -> [AxisId; 2] {
        let Connection { from, to, .. } = self.joining.connection;
        if self.upwards { [from, to] } else { [to, from] }
    }
}

/// A part of a route.
#[derive(Clone, Copy, Debug)]
pub(super) enum Leg<S> {
    /// From one axis of a link to another.
    Within(AxisId, AxisId),
    /// Over a joint; whether as its connection leads.
    Over(Joining<S>, bool),
}

/// The way from one axis to another of the same cluster along its tree.
#[derive(Debug)]
pub(super) struct Route<S> {
    pub(super) legs: Vec<Leg<S>>,
    /// The joints between it and the base, which carry the whole way.
    pub(super) carriers: Vec<Joining<S>>,
}

/// For each link, how it hangs on another.
#[derive(Clone, Debug)]
pub(super) struct Tree<S>(Vec<Option<Hold<S>>>);

impl<S: Copy> Tree<S> {
    /// No link hangs on another.
    pub(super) fn new(links: usize) -> Self {
        Self(vec![None; links])
    }

    /// The holds from a link to its root, each with the link that it holds.
    fn holds(&self, link: LinkId) -> Vec<(LinkId, Hold<S>)> {
        let mut holds = Vec::new();
        let mut at = link;
        while let Some(hold) = self.0[at.index()] {
            holds.push((at, hold));
            at = hold.on;
        }
        holds
    }

    fn root(&self, link: LinkId) -> LinkId {
        self.holds(link).last().map_or(link, |(_, hold)| hold.on)
    }

    /// Brings the trees of the two links of a connection together: the lower root stays one.
    pub(super) fn join(&mut self, [from, to]: [LinkId; 2], joining: Joining<S>) {
        let (stays, comes) = (self.root(from), self.root(to));
        let upwards = comes < stays;
        let (mut link, on) = if upwards { (from, to) } else { (to, from) };
        let mut hold = Hold { on, joining, upwards };
        if stays == comes {
            return;
        }
        // The link on which this one hung now hangs on it.
        while let Some(before) = self.0[link.index()].replace(hold) {
            hold = Hold { on: link, upwards: !before.upwards, ..before };
            link = before.on;
        }
    }

    /// The way from an axis of one link to an axis of another in the same cluster.
    pub(super) fn route(&self, from: (LinkId, AxisId), to: (LinkId, AxisId)) -> Route<S> {
        let (mut up, mut down) = (self.holds(from.0), self.holds(to.0));
        let mut carriers = Vec::new();
        while let (Some((a, hold)), Some((b, _))) = (up.last(), down.last())
            && a == b
        {
            carriers.push(hold.joining);
            up.pop();
            down.pop();
        }
        let mut legs = Vec::new();
        let (mut start, mut end) = (from.1, to.1);
        for (_, hold) in up {
            let [own, next] = hold.axes();
            legs.extend([Leg::Within(start, own), Leg::Over(hold.joining, hold.upwards)]);
            start = next;
        }
        let mut back = Vec::new();
        for (_, hold) in down {
            let [own, next] = hold.axes();
            back.extend([Leg::Within(own, end), Leg::Over(hold.joining, !hold.upwards)]);
            end = next;
        }
        legs.push(Leg::Within(start, end));
        legs.extend(back.into_iter().rev());
        Route { legs, carriers }
    }
}
