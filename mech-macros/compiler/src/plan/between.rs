//! Connections between clusters, and the rings they form.

use super::coupled::Block;
use super::step::{Connection, ConnectionKind};
use crate::model::{Axis, LinkId, Model};
use crate::structure::Pin;
use std::collections::BTreeMap;

/// Two clusters, by their bases, the lower first, and an unknown connection that joins them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Between {
    pub(super) a: LinkId,
    pub(super) b: LinkId,
    pub(super) connection: Connection,
    /// The pin it lies on, by its number.
    pub(super) pin: Option<usize>,
}

impl Between {
    /// The connection, from this cluster to the other.
    pub(super) fn from(self, base: LinkId) -> Connection {
        if base == self.a {
            self.connection
        } else {
            self.connection.reverse()
        }
    }

    /// The cluster on the other side.
    pub(super) fn beyond(self, base: LinkId) -> LinkId {
        if base == self.a { self.b } else { self.a }
    }

    fn slides(self) -> bool {
        self.connection.slides()
    }
}

/// The connection of two links on a pin, named by the pin's first joint.
pub(super) fn pivot(pin: &Pin, from: LinkId, to: LinkId) -> Option<Connection> {
    let (from, to) = (pin.axis_of(from)?, pin.axis_of(to)?);
    Some(Connection {
        kind: ConnectionKind::Revolute,
        from,
        to,
        joint: *pin.joints.first()?,
    })
}

/// All rings of three connections, and of two that slide, each with the connections by which its clusters hang on the lowest.
/// Ordered by the bases of their clusters.
pub(super) fn rings(model: &Model, all: &[Between]) -> Vec<Block> {
    let mut found: Vec<([LinkId; 3], Block)> = Vec::new();
    for pair in all.windows(2) {
        if let Some(ring) = wedge(model, pair[0], pair[1]) {
            let tree = vec![ring[0]];
            found.push(([pair[0].a, pair[0].b, pair[0].b], (vec![ring], tree)));
        }
    }
    // By the pair of clusters that is not the lowest: these have few neighbours, the ground may have many.
    let mut below: BTreeMap<LinkId, Vec<Between>> = BTreeMap::new();
    for between in all {
        below.entry(between.b).or_default().push(*between);
    }
    for across in all {
        for near in below.get(&across.a).into_iter().flatten() {
            let start = all.partition_point(|known| (known.a, known.b) < (near.a, across.b));
            let far = all
                .get(start)
                .filter(|known| (known.a, known.b) == (near.a, across.b));
            if let Some(ring) = far.and_then(|far| triangle(*near, *across, *far)) {
                let tree = vec![ring[0], ring[2].reverse()];
                found.push(([near.a, near.b, across.b], (vec![ring], tree)));
            }
        }
    }
    found.sort_by_key(|(bases, _)| *bases);
    found.dedup_by_key(|(bases, _)| *bases);
    found.into_iter().map(|(_, block)| block).collect()
}

/// The ring of three connections between three clusters: from the lowest to the next, across, and back.
fn triangle(near: Between, across: Between, far: Between) -> Option<Vec<Connection>> {
    // Three clusters on one pin are no loop, and three slides say only two things.
    let one_pin = near.pin.is_some() && near.pin == far.pin && far.pin == across.pin;
    let turns = !(near.slides() && across.slides() && far.slides());
    (turns && !one_pin).then(|| vec![near.connection, across.connection, far.connection.reverse()])
}

/// The ring that two connections between the same two clusters form, if it determines their places: two slides that are not
/// parallel.
fn wedge(model: &Model, first: Between, second: Between) -> Option<Vec<Connection>> {
    let same = (first.a, first.b) == (second.a, second.b) && first.slides() && second.slides();
    let [p, q] = [first, second].map(|between| {
        (
            model.axis(between.connection.from),
            model.axis(between.connection.to),
        )
    });
    // Guides of one link in both clusters are seen to be parallel at once; those that params turn differently are not.
    let parallel = |a: &Axis, b: &Axis| {
        let ([x, y], [u, v]) = (a.direction, b.direction);
        a.link == b.link
            && a.direction_formulas == b.direction_formulas
            && (x * v - y * u).abs() < 1e-12
    };
    let aligned = parallel(p.0, q.0) || parallel(p.1, q.1);
    (same && !aligned).then(|| vec![first.connection, second.connection.reverse()])
}
