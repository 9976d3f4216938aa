//! Connections between clusters, and the rings they form.

use super::step::{Connection, ConnectionKind};
use crate::model::{LinkId, Model};
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
    /// The connection, walked away from this cluster.
    pub(super) fn from(self, base: LinkId) -> Connection {
        if base == self.a {
            self.connection
        } else {
            self.connection.reversed()
        }
    }

    /// The cluster on the other side.
    pub(super) fn beyond(self, base: LinkId) -> LinkId {
        if base == self.a { self.b } else { self.a }
    }

    fn slides(self) -> bool {
        self.connection.kind == ConnectionKind::Prismatic
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

/// The ring that three connections form, if they do: the first two begin in the ring's lowest cluster.
pub(super) fn triangle(
    first: Between,
    second: Between,
    all: &[Between],
) -> Option<Vec<Connection>> {
    if first.a != second.a || first.b == second.b {
        return None;
    }
    let (near, far) = if first.b < second.b {
        (first, second)
    } else {
        (second, first)
    };
    let start = all.partition_point(|known| (known.a, known.b) < (near.b, far.b));
    let across = all
        .get(start)
        .filter(|known| (known.a, known.b) == (near.b, far.b))?;
    // Three clusters on one pin are no loop, and three slides say only two things.
    let one_pin = near.pin.is_some() && near.pin == far.pin && far.pin == across.pin;
    let turns = !(near.slides() && across.slides() && far.slides());
    (turns && !one_pin).then(|| {
        vec![
            near.connection,
            across.connection,
            far.connection.reversed(),
        ]
    })
}

/// The ring that two connections between the same two clusters form, if it determines their places: two slides that are not
/// parallel.
pub(super) fn wedge(model: &Model, first: Between, second: Between) -> Option<Vec<Connection>> {
    let same = (first.a, first.b) == (second.a, second.b) && first.slides() && second.slides();
    let [p, q] = [first, second].map(|between| {
        (
            model.axis(between.connection.from),
            model.axis(between.connection.to),
        )
    });
    // Guides of one link in both clusters are seen to be parallel at once.
    let parallel = |a: [f64; 2], b: [f64; 2]| (a[0] * b[1] - a[1] * b[0]).abs() < 1e-12;
    let aligned = (p.0.link == q.0.link && parallel(p.0.direction, q.0.direction))
        || (p.1.link == q.1.link && parallel(p.1.direction, q.1.direction));
    (same && !aligned).then(|| vec![first.connection, second.connection.reversed()])
}
