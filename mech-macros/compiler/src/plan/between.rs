//! Connections between clusters, and the rings they form.

use super::coupled::Block;
use super::step::{Connection, ConnectionKind};
use crate::model::{Axis, LinkId, Model};
use crate::structure::Pin;

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

/// The ring of three connections between three clusters: from the lowest to the next, across, and back. With it stand the
/// connections by which the others hang on the lowest.
pub(super) fn ring_of_three(near: Between, across: Between, far: Between) -> Option<Block> {
    // Three clusters on one pin are no loop, and three slides say only two things.
    let one_pin = near.pin.is_some() && near.pin == far.pin && far.pin == across.pin;
    let turns = !(near.slides() && across.slides() && far.slides());
    (turns && !one_pin).then(|| {
        let ring = vec![near.connection, across.connection, far.connection.reverse()];
        (vec![ring], vec![near.connection, far.connection])
    })
}

/// The ring that two connections between the same two clusters form, if it determines their places: two slides that are not
/// parallel.
pub(super) fn ring_of_two(model: &Model, first: Between, second: Between) -> Option<Block> {
    let slide = first.slides() && second.slides();
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
    (slide && !aligned).then(|| {
        let ring = vec![first.connection, second.connection.reverse()];
        (vec![ring], vec![first.connection])
    })
}
