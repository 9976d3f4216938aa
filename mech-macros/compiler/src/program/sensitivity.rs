//! Sensitivities: the rates of everything with each param.

use super::node::{Op, Value};
use super::{BlockKind, Program};
use crate::model::{AxisId, JointId};
use crate::program::live::iteration;

/// For each param, the rates of everything if it alone changes, at a rate of one: as a motor's influence coefficients.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sensitivity {
    /// The points that are shown and have a name.
    pub points: Vec<AxisId>,
    /// The joints that are shown.
    pub joints: Vec<JointId>,
    /// One for each param.
    pub of_params: Vec<ParamRates<Value>>,
}

/// The rates of everything if one param alone changes, at a rate of one.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ParamRates<V> {
    /// For each moving link whose pose is kept its angular velocity, and the rates of x and y.
    pub links: Vec<[V; 3]>,
    /// For each point the rates of its place in the scene, which may also move in its link.
    pub points: Vec<[V; 2]>,
    /// For each joint the rate of its coordinate.
    pub joints: Vec<V>,
}

impl<V: Copy> ParamRates<V> {
    /// All values that they consist of.
    pub fn roots(&self) -> impl Iterator<Item = V> + '_ {
        let (links, points) = (self.links.iter().flatten(), self.points.iter().flatten());
        links.chain(points).chain(&self.joints).copied()
    }

    /// The same rates, each number replaced by what `each` makes of it.
    pub fn map<W>(&self, each: impl Fn(V) -> W) -> ParamRates<W> {
        ParamRates {
            links: self.links.iter().map(|link| link.map(&each)).collect(),
            points: self.points.iter().map(|point| point.map(&each)).collect(),
            joints: self.joints.iter().map(|&joint| each(joint)).collect(),
        }
    }
}

impl Sensitivity {
    /// All values that it consists of.
    pub fn roots(&self) -> impl Iterator<Item = Value> + '_ {
        self.of_params.iter().flat_map(ParamRates::roots)
    }
}

impl Program {
    /// For each value whether it depends on a param, through whatever is between.
    #[must_use]
    pub fn depends_on_params(&self) -> Vec<bool> {
        let motors = self.motors.len();
        self.depends_on(|op| matches!(op, Op::Input(input) if input.motor(motors).is_none()))
    }

    /// For each value whether it depends on one that such an operation makes, through whatever is between.
    pub(super) fn depends_on(&self, source: impl Fn(Op) -> bool) -> Vec<bool> {
        let mut dependent: Vec<bool> = Vec::with_capacity(self.ssa.nodes.len());
        for node in &self.ssa.nodes {
            let depends = |value: Value| dependent[value.index()];
            let is = match node.op {
                op if source(op) => true,
                Op::Solved(block, _) => iteration(&self.ssa.blocks, block).into_iter().any(depends),
                op => op.operands().any(depends),
            };
            dependent.push(is);
        }
        dependent
    }

    /// The loops, by number, that a param has a part in.
    #[must_use]
    pub fn dependent_loops(&self) -> Vec<usize> {
        if self.params.is_empty() {
            return Vec::new();
        }
        let dependent = self.depends_on_params();
        let any = |values: Vec<Value>| values.iter().any(|value| dependent[value.index()]);
        let loops = self.block_ids().filter_map(|block| {
            let (values, number) = match &self.ssa.blocks[block.index()].kind {
                BlockKind::Straight => return None,
                BlockKind::ClosedForm(closed) => {
                    let found = closed.found.iter().copied();
                    let values = found.chain([closed.discriminant, closed.sine]);
                    (values.collect(), closed.number)
                }
                BlockKind::Newton(newton) => (iteration(&self.ssa.blocks, block), newton.number),
            };
            any(values).then_some(number)
        });
        loops.collect()
    }
}
