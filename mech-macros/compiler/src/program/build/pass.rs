//! The pass that finds the positions of all links, step by step.

use super::SolvedLoop;
use super::continuous::ContinuousAngles;
use super::lowering::Lowering;
use super::predictor::Predictor;
use super::sources::Sources;
use super::watching::Watches;
use crate::model::{InputId, JointId, Model};
use crate::plan::{Arithmetic, Plan, Rational, Source, float_of};
use crate::program::node::{Op, Value};
use num_traits::ToPrimitive;
use std::f64::consts::TAU;

/// The pass that finds the positions of all links.
pub(super) struct PositionPass<'m> {
    pub(super) lowering: Lowering<'m>,
    pub(super) sources: Sources,
    pub(super) watches: Watches,
    pub(super) predictor: Predictor,
    pub(super) continuous: ContinuousAngles,
    pub(super) followers: Vec<Follower>,
    pub(super) loops: Vec<SolvedLoop>,
}

/// A follower that was put where its cam has it.
pub(super) struct Follower {
    pub(super) cam: JointId,
    /// The coordinate of the shaft.
    pub(super) shaft: Value,
    /// The coordinate of the follower.
    pub(super) value: Value,
    /// Whether its law differs from turn to turn: then not all of its motion was examined at compile time.
    pub(super) wanders: bool,
}

impl<'m> PositionPass<'m> {
    pub(super) fn new(model: &'m Model, plan: &'m Plan) -> Self {
        Self {
            lowering: Lowering::new(model, plan),
            sources: Sources::new(plan),
            watches: Watches::default(),
            predictor: Predictor::new(model),
            continuous: ContinuousAngles::new(model),
            followers: Vec::new(),
            loops: Vec::new(),
        }
    }

    /// The part of a source in a coordinate. Of a motor's whole turns, an angle needs only the remainder.
    pub(super) fn share(&mut self, number: usize, part: &Rational, is_angle: bool) -> Value {
        let Self { lowering, watches, .. } = self;
        let source = self.sources.value(lowering, watches, number);
        let (model, plan, ssa) = (lowering.model, lowering.plan, &mut lowering.ssa);
        let factor = ssa.constant(float_of(part));
        let share = ssa.mul(factor, source);
        let Source::Motor(motor) = plan.sources[number] else {
            return share;
        };
        let joint = model.motor(motor).joint;
        if !model.turns(joint) {
            return share;
        }
        let name = format!("{}_turns", model.joint(joint).name);
        let turns = match (is_angle, part.numer().to_i64(), part.denom().to_i64()) {
            (true, Some(_), Some(1)) => return share,
            (true, Some(numerator), Some(denominator)) => {
                let turns =
                    ssa.make(Op::PartOfTurns(InputId::of_motor(motor), numerator, denominator));
                ssa.name(turns, name)
            }
            _ => {
                let turns = ssa.make(Op::Turns(InputId::of_motor(motor)));
                let turns = ssa.name(turns, name);
                let turn = ssa.constant(TAU);
                let turns = ssa.mul(turn, turns);
                ssa.mul(factor, turns)
            }
        };
        ssa.add(share, turns)
    }
}
