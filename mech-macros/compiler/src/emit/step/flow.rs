//! The flow of values between blocks.

use crate::program::{BlockId, Op, Program, Slot, Value, iteration};
use std::collections::BTreeSet;

/// The inputs and outputs of a block.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Flow {
    /// Values of earlier blocks, and motors.
    pub(super) takes: BTreeSet<Value>,
    /// Values that later blocks or the result need.
    pub(super) gives: BTreeSet<Value>,
    /// The numbers of the links whose last poses are read.
    pub(super) links: BTreeSet<usize>,
    /// Whether anything of the last position is read.
    pub(super) reads_last: bool,
}

/// Whether an operation reads a parameter of the step: something about a motor, a load, or the time.
pub(super) fn is_given(op: Op) -> bool {
    matches!(
        op,
        Op::Input(_)
            | Op::Turns(_)
            | Op::PartOfTurns(..)
            | Op::Rate(_)
            | Op::Acceleration(_)
            | Op::Load(_)
            | Op::Time
    )
}

/// Whether an operation belongs to a block.
pub(super) fn is_computed(op: Op) -> bool {
    !is_given(op) && !matches!(op, Op::Constant(_) | Op::Last(_))
}

/// The flow of each block.
pub(super) fn flows(program: &Program) -> Vec<Flow> {
    let mut flows = vec![Flow::default(); program.ssa.blocks.len()];
    let mut read = |value: Value, by: BlockId| match program.node(value).op {
        Op::Constant(_) => {}
        Op::Last(slot) => {
            flows[by.index()].reads_last = true;
            if let Slot::Pose(link, _) = slot {
                flows[by.index()].links.insert(link);
            }
        }
        op => {
            let from = program.node(value).block;
            if is_given(op) || from != by {
                flows[by.index()].takes.insert(value);
            }
            // A parameter is known everywhere, whichever block reads it first.
            if from != by && !is_given(op) {
                flows[from.index()].gives.insert(value);
            }
        }
    };
    for node in program.live_values().map(|value| program.node(value)) {
        let operands = node.op.operands();
        operands.for_each(|operand| read(operand, node.block));
    }
    for block in program.block_ids() {
        let Some(newton) = program.newton(block) else {
            continue;
        };
        // A block whose result nothing needs is not run.
        let mut scalars = newton.scalars.iter();
        if scalars.all(|scalar| program.live[scalar.now.index()]) {
            // Loops that hold the same lengths again share what those add up to.
            for value in iteration(&program.ssa.blocks, block) {
                read(value, block);
            }
        }
    }
    for system in program.live_systems() {
        let coefficients = system.coefficients();
        coefficients.for_each(|&value| read(value, system.block));
    }
    let margins = program.margins().map(|(_, closed)| closed.margin);
    for value in program.roots().chain(margins) {
        let node = program.node(value);
        if is_computed(node.op) {
            flows[node.block.index()].gives.insert(value);
        }
    }
    flows
}
