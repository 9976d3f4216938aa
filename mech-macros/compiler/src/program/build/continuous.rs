//! The coordinates of joints over any number of turns: where that is asked for, and where torsional springs need it.

use super::lowering::Lowering;
use super::watching::Watches;
use crate::model::{AxisId, InputId, JointId, JointKind, Model};
use crate::plan::{Arithmetic, Connection, Turning};
use crate::program::JointAngle;
use crate::program::node::{Op, Value};
use std::f64::consts::TAU;

/// The joints whose coordinates are carried from position to position.
pub(super) struct ContinuousAngles {
    joints: Vec<ContinuousJoint>,
    /// The angles, whole turns included, that gears or cams give.
    known: Vec<(Connection, Value)>,
}

/// A joint whose coordinate is carried: no motor gives it.
struct ContinuousJoint {
    joint: JointId,
    axes: [AxisId; 2],
}

impl ContinuousAngles {
    pub(super) fn new(model: &Model) -> Self {
        let revolute = |joint| match model.joint(joint).kind {
            JointKind::Revolute(a, b) => Some(ContinuousJoint { joint, axes: [a, b] }),
            _ => None,
        };
        let joints = model.continuous_joints().into_iter();
        Self { joints: joints.filter_map(revolute).collect(), known: Vec::new() }
    }

    /// Whether the angle of this connection is carried.
    pub(super) fn contains(&self, connection: Connection) -> bool {
        let mut joints = self.joints.iter();
        joints.any(|joint| connection.turns_between(joint.axes).is_some())
    }

    /// Notes the angle of a connection, whole turns included.
    pub(super) fn note(&mut self, connection: Connection, whole: Value) {
        self.known.push((connection, whole));
    }

    /// Carries the angles of all these joints.
    pub(super) fn carry(&self, lowering: &mut Lowering<'_>, watches: &mut Watches) {
        for &ContinuousJoint { joint, axes } in &self.joints {
            let name = format!("{}_angle", lowering.model.joint(joint).name);
            let state = if let Some(angle) = self.known_angle(lowering, axes) {
                lowering.ssa.record(angle).index
            } else {
                let between = axes.map(|axis| lowering.placement.heading(&mut lowering.ssa, axis));
                let principal = lowering.ssa.angle_between(between);
                let start = lowering.ssa.at_start(principal);
                watches.count_turns(lowering, Turning::Joint(joint), principal, start)
            };
            let angle = lowering.ssa.state(state);
            lowering.ssa.name(angle, name);
            let angles = &mut lowering.layout.joint_angles;
            angles.push(JointAngle { joint, state });
        }
    }

    /// The angle from one axis to another, if gears or cams give it.
    fn known_angle(&self, lowering: &mut Lowering<'_>, axes: [AxisId; 2]) -> Option<Value> {
        let mut known = self.known.iter();
        let (value, forwards) = known.find_map(|(connection, whole)| {
            let forwards = connection.turns_between(axes)?;
            Some((*whole, forwards))
        })?;
        Some(if forwards { value } else { lowering.ssa.neg(value) })
    }
}

impl Lowering<'_> {
    /// The coordinate of a joint with a torsional spring, over any number of turns.
    pub(super) fn sprung_coordinate(&mut self, joint: JointId) -> Option<Value> {
        if let Some(motor) = self.model.motor_of(joint) {
            let value = self.ssa.make(Op::Input(InputId::of_motor(motor)));
            let turns = self.ssa.make(Op::Turns(InputId::of_motor(motor)));
            let turn = self.ssa.constant(TAU);
            let whole = self.ssa.mul(turn, turns);
            return Some(self.ssa.add(value, whole));
        }
        let mut angles = self.layout.joint_angles.iter();
        let carried = angles.find(|angle| angle.joint == joint)?;
        Some(self.ssa.state(carried.state))
    }
}
