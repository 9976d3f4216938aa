//! The coordinates of joints that go on over any number of turns: where that is asked for, and where torsional springs need it.

use super::Writer;
use crate::model::{AxisId, JointId, JointKind, Law, Model};
use crate::plan::{Algebra, Cam, Connection, Mesh, Turning};
use crate::program::JointAngle;
use crate::program::node::{Op, Value};

/// The angle of a connection, whole turns included, as gears or cams give it.
pub(super) struct WholeAngle {
    connection: Connection,
    value: Value,
}

/// A joint whose coordinate is carried: no motor gives it.
#[derive(Clone, Copy)]
pub(super) struct Continuous {
    joint: JointId,
    axes: [AxisId; 2],
}

/// The joints whose coordinates are carried.
pub(super) fn continuous_joints(model: &Model) -> Vec<Continuous> {
    let revolute = |joint| match model.joint(joint).kind {
        JointKind::Revolute(a, b) => Some(Continuous {
            joint,
            axes: [a, b],
        }),
        _ => None,
    };
    let joints = model.continuous_joints().into_iter();
    joints.filter_map(revolute).collect()
}

impl Writer<'_> {
    /// Notes the whole angle of a joint that gears turn, if it is carried.
    pub(super) fn note_mesh(&mut self, mesh: &Mesh, offset: Value) {
        if !self.is_continuous(mesh.connection) {
            return;
        }
        let mut value = offset;
        for (number, part) in &mesh.parts {
            let share = self.share(*number, part, false);
            value = self.builder.add(value, share);
        }
        let connection = mesh.connection;
        self.whole_angles.push(WholeAngle { connection, value });
    }

    /// Notes the whole angle of a joint that a cam turns, if it is carried.
    pub(super) fn note_cam(&mut self, cam: &Cam, law: &Law) {
        if !self.is_continuous(cam.connection) {
            return;
        }
        let shaft = self.shaft(cam, law.winding() == Some(0.0));
        let value = self.builder.law(law, shaft);
        let connection = cam.connection;
        self.whole_angles.push(WholeAngle { connection, value });
    }

    /// Whether the whole angle of this connection is carried.
    fn is_continuous(&self, connection: Connection) -> bool {
        let mut carried = self.continuous.iter();
        carried.any(|carried| connection.turns_between(carried.axes).is_some())
    }

    /// Carries these angles from position to position.
    pub(super) fn carry_continuous(&mut self) {
        for Continuous { joint, axes } in self.continuous.clone() {
            let name = format!("{}_angle", self.model.joint(joint).name);
            let state = self.state.len();
            if let Some(angle) = self.whole_angle(axes) {
                self.keep(self.builder.at_start(angle));
                self.state[state] = angle;
                self.builder.name(angle, name);
            } else {
                let principal = self.angle_between(axes);
                let start = self.builder.at_start(principal);
                self.unwrapped(Turning::Joint(joint), principal, start, name);
            }
            self.joint_angles.push(JointAngle { joint, state });
        }
    }

    /// The coordinate of a joint with a torsional spring, over any number of turns.
    pub(super) fn sprung_coordinate(&mut self, joint: JointId) -> Option<Value> {
        if let Some(motor) = self.model.motor_of(joint) {
            let value = self.builder.make(Op::Motor(motor.index()));
            let turns = self.builder.make(Op::Turns(motor.index()));
            let turn = self.builder.constant(std::f64::consts::TAU);
            let whole = self.builder.mul(turn, turns);
            return Some(self.builder.add(value, whole));
        }
        let mut angles = self.joint_angles.iter();
        let carried = angles.find(|angle| angle.joint == joint)?;
        Some(self.state[carried.state])
    }

    /// The angle from one axis to another, if gears or cams give it.
    fn whole_angle(&mut self, axes: [AxisId; 2]) -> Option<Value> {
        let mut known = self.whole_angles.iter();
        let (value, forwards) = known.find_map(|whole| {
            let forwards = whole.connection.turns_between(axes)?;
            Some((whole.value, forwards))
        })?;
        Some(if forwards {
            value
        } else {
            self.builder.neg(value)
        })
    }

    /// The angle from the direction of one axis to that of another, between −π and π.
    fn angle_between(&mut self, axes: [AxisId; 2]) -> Value {
        let [from, to] = axes.map(|axis| self.placement.heading(&mut self.builder, axis));
        let (sin, cos) = (self.builder.cross(from, to), self.builder.dot(from, to));
        self.builder.make(Op::Atan2(sin, cos))
    }
}
