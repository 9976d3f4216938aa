//! Connections between clusters, and the rings they form.

use super::step::{Connection, ConnectionKind};
use crate::model::LinkId;
use crate::structure::Pin;
use petgraph::unionfind::UnionFind;
use std::collections::BTreeMap;

/// Rings to be closed together, and the connections by which the clusters hang on the first.
pub(super) type Block = (Vec<Vec<Connection>>, Vec<Connection>);

/// Two clusters, by their bases, the lower first, and an unknown connection that joins them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Between {
    pub(super) a: LinkId,
    pub(super) b: LinkId,
    pub(super) connection: Connection,
    /// The pin it lies on, by its number.
    pub(super) pin: Option<usize>,
    /// The direction in which it slides, by its number: slides of one number stay parallel.
    pub(super) direction: Option<usize>,
}

impl Between {
    /// The connection, from this cluster to the other.
    pub(super) fn from(self, base: LinkId) -> Connection {
        if base == self.a { self.connection } else { self.connection.reverse() }
    }

    /// The cluster on the other side.
    pub(super) fn beyond(self, base: LinkId) -> LinkId {
        if base == self.a { self.b } else { self.a }
    }

    /// Whether both turn about one pin, or slide in one direction.
    fn is_like(&self, other: &Self) -> bool {
        (self.pin, self.direction) == (other.pin, other.direction)
    }

    fn slides(self) -> bool {
        self.connection.slides()
    }
}

/// The connection of two links on a pin, named by the pin's first joint.
pub(super) fn pivot(pin: &Pin, from: LinkId, to: LinkId) -> Option<Connection> {
    let (from, to) = (pin.axis_of(from)?, pin.axis_of(to)?);
    Some(Connection { kind: ConnectionKind::Revolute, from, to, joint: *pin.joints.first()? })
}

/// The ring of three connections between three clusters: from the lowest to the next, across, and back. With it stand the
/// connections by which the others hang on the lowest.
pub(super) fn ring_of_three(near: Between, across: Between, far: Between) -> Option<Block> {
    // Three slides say only two things, and two of one direction, or two turns about one pin, leave the cluster between them free.
    let turns = !(near.slides() && across.slides() && far.slides());
    let pairs = [(near, across), (across, far), (far, near)];
    let alike = pairs.iter().any(|(one, other)| one.is_like(other));
    (turns && !alike).then(|| {
        let ring = vec![near.connection, across.connection, far.connection.reverse()];
        (vec![ring], vec![near.connection, far.connection])
    })
}

/// The ring that two connections between the same two clusters form, if it determines their places: two slides that are not
/// parallel.
pub(super) fn ring_of_two(first: Between, second: Between) -> Option<Block> {
    let slide = first.slides() && second.slides();
    (slide && !first.is_like(&second)).then(|| {
        let ring = vec![first.connection, second.connection.reverse()];
        (vec![ring], vec![first.connection])
    })
}

/// Links and clusters that slide on each other in one direction, directly or over others.
pub(super) struct Sliding {
    /// Links or clusters, for each direction on which they slide.
    places: BTreeMap<(usize, LinkId), usize>,
    joined: UnionFind<usize>,
}

impl Default for Sliding {
    fn default() -> Self {
        Self { places: BTreeMap::new(), joined: UnionFind::new_empty() }
    }
}

impl Sliding {
    /// Lets two slide on each other in a direction; whether they did not before.
    pub(super) fn join(&mut self, direction: usize, a: LinkId, b: LinkId) -> bool {
        let [a, b] = [a, b].map(|one| {
            let new = || self.joined.new_set();
            *self.places.entry((direction, one)).or_insert_with(new)
        });
        self.joined.union(a, b)
    }
}
