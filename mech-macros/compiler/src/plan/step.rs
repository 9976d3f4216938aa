//! The steps by which every position becomes known.

use super::linear_relations::Rational;
use super::unknown::Unknown;
use crate::bug::bug;
use crate::model::{AxisId, JointId, LinkId, MotorId};

/// One step: it merges clusters of links, so that the links inside keep known relative positions.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Step {
    /// A joint that never turns: its coordinate is the same for ever.
    Weld(Weld),
    /// A motor gives the coordinate of its joint.
    Drive(Drive),
    /// Gears, belts or racks give the coordinate of a joint.
    Mesh(Mesh),
    /// A cam gives the coordinate of its follower's joint.
    Cam(Cam),
    /// Clusters joined in rings by joints of unknown coordinate.
    Close(Loop),
}

/// A weld, or a pin that does not turn in its slot.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Weld {
    /// The connection that it makes.
    pub connection: Connection,
    /// The direction of the second axis, seen from the first.
    pub direction: [f64; 2],
}

/// A joint whose coordinate a motor gives.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Drive {
    /// The motor.
    pub motor: MotorId,
    /// The connection that the motor moves.
    pub connection: Connection,
}

/// A joint whose coordinate follows from others by rolling.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Mesh {
    /// A gear, belt or rack that moves it.
    pub by: JointId,
    /// The connection that is moved.
    pub connection: Connection,
    /// Its displacement since the start: the sum of these parts of what the sources have moved, by their number in
    /// [`Plan::sources`](super::Plan::sources).
    pub parts: Vec<(usize, Rational)>,
}

/// A joint whose coordinate is a function of that of another.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Cam {
    /// The cam.
    pub by: JointId,
    /// The follower, as its joint is declared.
    pub connection: Connection,
    /// The displacement of the shaft since the start: the sum of these parts of what the sources have moved, by their number in
    /// [`Plan::sources`](super::Plan::sources).
    pub parts: Vec<(usize, Rational)>,
}

/// A quantity that is known when gears, belts and racks are solved.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Source {
    /// The coordinate of a motor.
    Motor(MotorId),
    /// The angle between two links that loops have solved.
    Angle {
        /// The link from which it is measured.
        from: LinkId,
        /// The link to which it is measured.
        to: LinkId,
    },
    /// The coordinate of a sliding joint that loops have solved.
    Displacement(JointId),
}

/// Joints whose coordinates are found together.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Loop {
    /// The rings that must close. Every connection begins in the cluster in which the one before it ends.
    pub rings: Vec<Vec<Connection>>,
    /// For each cluster but the first, which is known, the connection by which it hangs on one before it.
    pub tree: Vec<Connection>,
    /// The directions and displacements that rolling ties to others of this loop, or to what is known.
    pub ties: Vec<Tie>,
    /// All joints of the rings: the unknown ones and, between them, paths through what is already known.
    pub members: Vec<JointId>,
    /// One more than the level of the last loop it depends on; a loop that only motors and gears lead to has level 1.
    pub level: usize,
    /// The loops, by their number in the sequence, whose results it needs directly.
    pub needs: Vec<usize>,
}

/// An unknown that rolling ties: how far it moves from the start.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Tie {
    /// The unknown that is tied.
    pub of: Unknown,
    /// Parts of what other unknowns of the loop have moved.
    pub parts: Vec<(Unknown, Rational)>,
    /// Parts of what sources have moved, by their number in [`Plan::sources`](super::Plan::sources).
    pub sources: Vec<(usize, Rational)>,
}

/// Two axes that coincide, one on a link of each of two clusters.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Connection {
    /// Whether the links turn about it or slide along it.
    pub kind: ConnectionKind,
    /// The axis one comes from.
    pub from: AxisId,
    /// The axis one goes to.
    pub to: AxisId,
    /// The declared joint after which the connection is named. On a pin of several links no joint may join these two directly: then a
    /// joint that holds one of them there.
    pub joint: JointId,
}

impl Connection {
    /// The same connection, from its second axis to its first.
    #[must_use]
    pub fn reverse(self) -> Self {
        Self { from: self.to, to: self.from, ..self }
    }

    /// Whether its links slide along it.
    #[must_use]
    pub fn slides(&self) -> bool {
        self.kind == ConnectionKind::Prismatic
    }

    /// Whether it goes forwards from the first to the second of these axes, or backwards; none if it joins others.
    #[must_use]
    pub fn turns_between(&self, [a, b]: [AxisId; 2]) -> Option<bool> {
        match (self.from, self.to) {
            (from, to) if (from, to) == (a, b) => Some(true),
            (from, to) if (from, to) == (b, a) => Some(false),
            _ => None,
        }
    }
}

/// The freedom of a connection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum ConnectionKind {
    /// Rotation: the coordinate is an angle.
    Revolute,
    /// Sliding: the coordinate is a length.
    Prismatic,
}

impl Loop {
    /// The connection by which the first of its clusters hangs on what is known.
    pub(crate) fn first(&self) -> Connection {
        let Some(&first) = self.tree.first() else {
            bug!("a loop has no cluster that is not known");
        };
        first
    }

    /// The joints of unknown coordinate, in the order of the rings.
    #[must_use]
    pub fn unknowns(&self) -> Vec<JointId> {
        let mut unknowns: Vec<JointId> = Vec::new();
        for connection in self.rings.iter().flatten() {
            if !unknowns.contains(&connection.joint) {
                unknowns.push(connection.joint);
            }
        }
        unknowns
    }

    /// The joints of unknown coordinate, and how each moves.
    pub fn connections(&self) -> impl Iterator<Item = Connection> {
        let unknowns = self.unknowns().into_iter();
        unknowns.filter_map(|joint| {
            self.rings.iter().flatten().find(|connection| connection.joint == joint).copied()
        })
    }

    /// Whether its joints hold more than once: two clusters are joined by a turning joint and any other.
    #[must_use]
    pub fn is_redundant(&self) -> bool {
        let turns = |ring: &Vec<Connection>| {
            ring.iter().any(|connection| connection.kind == ConnectionKind::Revolute)
        };
        self.rings.iter().any(|ring| ring.len() == 2 && turns(ring))
    }

    /// Whether several rings have to be closed together.
    #[must_use]
    pub fn is_coupled(&self) -> bool {
        self.rings.len() > 1
    }
}
