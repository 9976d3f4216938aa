//! What flows between blocks: which values each takes from earlier ones and gives to later ones.

use crate::program::{BlockId, Op, Program, Slot, Value};
use std::collections::BTreeSet;

/// What a block takes and gives.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Flow {
    /// Values made by earlier blocks, and motors.
    pub(super) takes: Vec<Value>,
    /// Values that later blocks or the result need.
    pub(super) gives: Vec<Value>,
    /// The links whose last pose is read, by number.
    pub(super) links: Vec<usize>,
    /// Whether anything of the last position is read.
    pub(super) reads_last: bool,
}

/// Whether it is given from outside: something about a motor, or the time.
pub(super) fn is_given(op: Op) -> bool {
    matches!(
        op,
        Op::Motor(_)
            | Op::Turns(_)
            | Op::Turned(..)
            | Op::Rate(_)
            | Op::Acceleration(_)
            | Op::Load(_)
            | Op::Time
    )
}

/// Whether a block makes it.
pub(super) fn is_made(op: Op) -> bool {
    !is_given(op) && !matches!(op, Op::Constant(_) | Op::Last(_))
}

/// The flow of every block.
pub(super) fn flows(program: &Program) -> Vec<Flow> {
    let mut takes: Vec<BTreeSet<Value>> = vec![BTreeSet::new(); program.blocks.len()];
    let mut gives = takes.clone();
    let mut links: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); program.blocks.len()];
    let mut reads_last = vec![false; program.blocks.len()];
    let mut read = |value: Value, by: BlockId| match program.node(value).op {
        Op::Constant(_) => {}
        Op::Last(slot) => {
            reads_last[by.index()] = true;
            if let Slot::Pose(link, _) = slot {
                links[by.index()].insert(link);
            }
        }
        op => {
            let from = program.node(value).block;
            if is_given(op) || from != by {
                takes[by.index()].insert(value);
            }
            // What is given from outside is known everywhere, whichever block speaks of it first.
            if from != by && !is_given(op) {
                gives[from.index()].insert(value);
            }
        }
    };
    for value in program.live_values() {
        let node = program.node(value);
        node.op
            .operands()
            .for_each(|operand| read(operand, node.block));
    }
    for block in program.block_ids() {
        let Some(newton) = program.newton(block) else {
            continue;
        };
        // A block whose result nothing needs is not run.
        if newton
            .scalars
            .iter()
            .all(|scalar| program.live[scalar.now.index()])
        {
            newton
                .scalars
                .iter()
                .for_each(|scalar| read(scalar.first, block));
        }
    }
    for system in program.live_systems() {
        let needed = system.coefficients();
        needed.for_each(|&value| read(value, system.block));
    }
    let margins = program.margins().map(|(_, closed)| closed.margin);
    for value in program.roots().chain(margins) {
        let node = program.node(value);
        if is_made(node.op) {
            gives[node.block.index()].insert(value);
        }
    }
    let parts = takes.into_iter().zip(gives).zip(links).zip(reads_last);
    parts
        .map(|(((takes, gives), links), reads_last)| Flow {
            takes: takes.into_iter().collect(),
            gives: gives.into_iter().collect(),
            links: links.into_iter().collect(),
            reads_last,
        })
        .collect()
}
