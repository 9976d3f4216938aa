//! Forces that are measured: what computes them is added to a program of positions, with the rates of motors and all loads put in.

use super::build::Seed;
use super::builder::SsaBuilder;
use super::in_time::InTime;
use super::node::{Op, Value};
use super::{Forces, Program};
use crate::model::{Model, MotorId, Quantity, ReactionPart};
use crate::plan::{Algebra, Arithmetic};

/// How a mechanism is moved, and what acts on it, where it is measured.
#[derive(Clone, Debug)]
pub(crate) struct Circumstances<'a> {
    /// How motors move.
    pub(crate) motion: Motion<'a>,
    /// The numbers of all loads.
    pub(crate) loads: &'a [f64],
    /// The program that computes forces, if any are measured.
    pub(crate) forces: Option<&'a Program>,
}

/// How motors move.
#[derive(Clone, Debug)]
pub(crate) enum Motion<'a> {
    /// Each at a rate that does not change.
    Even {
        /// The rate of each motor, for velocities and accelerations.
        rates: Vec<f64>,
        /// The same for forces: zero at rest.
        pushed: Vec<f64>,
    },
    /// By laws of the time, which is an input of this program of positions. Motors without a law stand.
    InTime(&'a InTime),
    /// At any rates and second rates: nobody gives them.
    Any,
}

impl Motion<'_> {
    /// What is known of inputs where something is differentiated by the time.
    pub(super) fn seed(&self) -> Seed {
        match self {
            Self::Even { .. } => Seed::Coasting,
            // What laws say is known.
            Self::InTime(_) => Seed::NONE,
            Self::Any => Seed::Given,
        }
    }

    /// The rate of a motor, for forces.
    fn pushed(&self, ssa: &mut SsaBuilder, motor: MotorId) -> Value {
        match self {
            Self::Even { pushed, .. } => ssa.constant(pushed[motor.index()]),
            Self::InTime(_) | Self::Any => ssa.make(Op::Rate(motor)),
        }
    }

    /// The second rate of a motor.
    fn second(&self, ssa: &mut SsaBuilder, motor: MotorId) -> Value {
        match self {
            Self::Even { .. } => ssa.constant(0.0),
            Self::InTime(_) | Self::Any => ssa.make(Op::Acceleration(motor)),
        }
    }
}

impl SsaBuilder {
    /// Goes on with a program of positions where motors move so.
    pub(super) fn resume_in(positions: &Program, motion: &Motion<'_>) -> Self {
        let mut ssa = Self::resume(positions);
        match motion {
            Motion::Even { rates, .. } => {
                for (motor, rate) in rates.iter().enumerate() {
                    let rate = ssa.constant(*rate);
                    ssa.give(Op::Rate(MotorId::new(motor)), rate);
                }
            }
            Motion::InTime(laws) => laws.give_to(&mut ssa, positions.motors.len()),
            Motion::Any => {}
        }
        ssa
    }

    /// Adds what computes forces; nothing if these are computed from other positions.
    pub(super) fn add_forces(
        &mut self,
        positions: &Program,
        circumstances: &Circumstances<'_>,
    ) -> Option<Forces<Value>> {
        let program = circumstances.forces?;
        let forces = program.forces()?;
        let nodes = &program.ssa.nodes;
        let mut needed = vec![false; nodes.len()];
        for value in forces.roots().iter().chain(program.poses.iter().flatten()) {
            needed[value.index()] = true;
        }
        for index in (0..nodes.len()).rev() {
            if needed[index] {
                for operand in nodes[index].op.operands() {
                    needed[operand.index()] = true;
                }
            }
        }
        let mut made: Vec<Value> = Vec::with_capacity(nodes.len());
        let unused = self.constant(0.0);
        for (node, needed) in nodes.iter().zip(needed) {
            let value = match node.op {
                _ if !needed => unused,
                Op::Rate(motor) => circumstances.motion.pushed(self, motor),
                Op::Acceleration(motor) => circumstances.motion.second(self, motor),
                Op::Load(number) => self.constant(circumstances.loads[number]),
                op => self.make_again(op.map(|operand| made[operand.index()])),
            };
            made.push(value);
        }
        let poses = program.poses.iter().flatten().map(|value| made[value.index()]);
        let is_same = poses.eq(positions.poses.iter().flatten().copied());
        is_same.then(|| forces.map(|value| made[value.index()]))
    }

    /// An operation of another program: what was made is made no second time, and what is known now is folded.
    fn make_again(&mut self, op: Op) -> Value {
        if let Some(known) = self.find(op) {
            return known;
        }
        match op {
            Op::Neg(a) => self.neg(a),
            Op::Abs(a) => self.abs(a),
            Op::Sqrt(a) => self.sqrt(a),
            Op::Add(a, b) => self.add(a, b),
            Op::Sub(a, b) => self.sub(a, b),
            Op::Mul(a, b) => self.mul(a, b),
            Op::Div(a, b) => self.div(a, b),
            Op::Max(a, b) => self.max(a, b),
            Op::CopySign(a, b) => self.copysign(a, b),
            op => self.make(op),
        }
    }

    /// A force or a torque; nothing if these do not tell it.
    pub(super) fn force(
        &mut self,
        model: &Model,
        (forces, motion): (&Forces<Value>, &Motion<'_>),
        quantity: Quantity,
    ) -> Option<Value> {
        match (quantity, forces) {
            (Quantity::Torque(motor), Forces::Holding(torques)) => Some(torques[motor.index()]),
            (Quantity::Torque(motor), Forces::InverseDynamics(found)) => {
                Some(found.torques[motor.index()])
            }
            (Quantity::Torque(motor), Forces::Inertia(found)) => {
                let mut torque = self.neg(found.drive[motor.index()]);
                for (other, part) in model.motor_ids().zip(&found.matrix[motor.index()]) {
                    let second = motion.second(self, other);
                    let share = self.mul(*part, second);
                    torque = self.add(torque, share);
                }
                Some(torque)
            }
            (Quantity::Power(motor), forces) => {
                let torque = self.force(model, (forces, motion), Quantity::Torque(motor))?;
                let rate = self.make(Op::Rate(motor));
                Some(self.mul(torque, rate))
            }
            (Quantity::Reaction(joint, part), Forces::InverseDynamics(found)) => {
                let number = model.declared_joints().position(|one| one == joint)?;
                let [x, y, torque] = found.reactions[number];
                Some(match part {
                    ReactionPart::X => x,
                    ReactionPart::Y => y,
                    ReactionPart::Torque => torque,
                })
            }
            _ => None,
        }
    }
}
