//! The steps by which every position becomes known.

use crate::model::{AxisId, JointId, Model, MotorId};

/// One step: it merges clusters of links, so that the links inside keep known relative positions.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// A motor gives the coordinate of its joint.
    Drive(Drive),
    /// A gear gives the angle of a wheel on its carrier.
    Mesh(Mesh),
    /// Three clusters joined in a ring by three joints of unknown coordinate.
    Close(Loop),
}

/// A joint whose coordinate a motor gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// The motor.
    pub motor: MotorId,
    /// What the motor moves.
    pub connection: Connection,
}

/// A wheel that another one drives.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// The gear.
    pub gear: JointId,
    /// The pin of the driving wheel: from the carrier to the wheel.
    pub input: Connection,
    /// The pin of the driven wheel: from the carrier to the wheel.
    pub output: Connection,
    /// The driven wheel's angle for one radian of the driving wheel's.
    pub speed: f64,
}

/// A loop of three unknowns.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// The three joints of unknown coordinate, walked round: from the first cluster, which is known, to the second, on to
    /// the third, and back to the first.
    pub ring: [Connection; 3],
    /// All joints of the cycle: the unknown ones and, between them, a way through what is already known.
    pub members: Vec<JointId>,
    /// One more than the level of the last loop it depends on; a loop that only motors and gears lead to has level 1.
    pub level: usize,
    /// The loops, by their number in the sequence, whose results it needs directly.
    pub needs: Vec<usize>,
}

/// Two axes that coincide, one on a link of each of two clusters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Connection {
    /// Whether the links turn about it or slide along it.
    pub kind: ConnectionKind,
    /// The axis one comes from.
    pub from: AxisId,
    /// The axis one goes to.
    pub to: AxisId,
    /// The declared joint that names it. On a pin of several links two of them may be joined by way of a third: then it
    /// is a joint of the pin that holds one of the two.
    pub joint: JointId,
}

/// What a connection allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConnectionKind {
    /// Rotation: the coordinate is an angle.
    Revolute,
    /// Sliding: the coordinate is a length.
    Prismatic,
}

impl Loop {
    /// The joints of unknown coordinate, in the order of the ring.
    #[must_use]
    pub fn unknowns(&self) -> [JointId; 3] {
        self.ring.map(|connection| connection.joint)
    }
}

impl Connection {
    /// The angle from the frame of the first link to that of the second when the coordinate is zero.
    #[must_use]
    pub fn frame_angle(&self, model: &Model) -> f64 {
        let heading = |axis| {
            let [x, y] = model.axis(axis).direction;
            f64::atan2(y, x)
        };
        heading(self.from) - heading(self.to)
    }

    /// The same connection, walked the other way.
    #[must_use]
    pub fn reversed(self) -> Self {
        Self {
            from: self.to,
            to: self.from,
            ..self
        }
    }
}
