//! Three links on three binary legs.

use super::step::{Connection, ConnectionKind, Loop};
use crate::model::{AxisId, LinkId};

/// A middle link and its legs, by the bases of their clusters.
pub(crate) struct Triad {
    pub(crate) middle: LinkId,
    pub(crate) legs: [Leg; 3],
}

/// A binary leg.
#[derive(Clone, Copy)]
pub(crate) struct Leg {
    pub(crate) base: LinkId,
    /// From what is known to the leg.
    pub(crate) foot: Connection,
    /// From the leg to the middle link.
    pub(crate) head: Connection,
}

impl Triad {
    /// The triad that a loop is, if it is one; `base` gives the base of the cluster in which an axis is.
    pub(crate) fn of(closing: &Loop, base: impl Fn(AxisId) -> LinkId) -> Option<Self> {
        let first = base(closing.tree.first()?.from);
        let mut connections: Vec<Connection> = Vec::new();
        for connection in closing.rings.iter().flatten() {
            let ends = |other: &Connection| [base(other.from), base(other.to)];
            let same = |other: &Connection| {
                ends(other) == ends(connection) || ends(&other.reverse()) == ends(connection)
            };
            if !connections.iter().any(same) {
                connections.push(*connection);
            }
        }
        let turns =
            connections.iter().all(|connection| connection.kind == ConnectionKind::Revolute);
        if !turns || connections.len() != 6 || closing.tree.len() != 4 {
            return None;
        }
        let from = |start: LinkId, end: LinkId| {
            let both =
                connections.iter().flat_map(|connection| [*connection, connection.reverse()]);
            both.into_iter()
                .find(|connection| base(connection.from) == start && base(connection.to) == end)
        };
        let others = || closing.tree.iter().map(|connection| base(connection.to));
        let middle = others().find(|&middle| from(first, middle).is_none())?;
        let leg = |leg: LinkId| {
            Some(Leg { base: leg, foot: from(first, leg)?, head: from(leg, middle)? })
        };
        let legs: Vec<Leg> =
            others().filter(|&other| other != middle).map(leg).collect::<Option<_>>()?;
        Some(Self { middle, legs: legs.try_into().ok()? })
    }
}
