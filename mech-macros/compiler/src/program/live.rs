//! Liveness: a value is live if a result depends on it. No code is emitted for the others.

use super::node::{BlockId, Op, Value};
use super::{Block, BlockKind, Program};

/// For each node whether it is needed.
pub(super) fn live(program: &Program) -> Vec<bool> {
    live_with(program, &[])
}

/// The same where these values are needed, too.
fn live_with(program: &Program, wanted: &[Value]) -> Vec<bool> {
    let mut live = vec![false; program.ssa.nodes.len()];
    let margins = program.closed_forms().map(|(_, closed)| closed.margin);
    let roots = program.roots().chain(margins);
    let mut waiting: Vec<Value> = roots.chain(wanted.iter().copied()).collect();
    while let Some(value) = waiting.pop() {
        if std::mem::replace(&mut live[value.index()], true) {
            continue;
        }
        let op = program.ssa.nodes[value.index()].op;
        waiting.extend(op.operands());
        if let Op::Linear(system, _) = op {
            waiting.extend(program.systems()[system].coefficients());
        }
        if let Op::Solved(block, _) = op {
            waiting.extend(iteration(&program.ssa.blocks, block));
        }
    }
    live
}

/// A program that computes these values, too.
pub(crate) fn computing(program: &Program, wanted: &[Value]) -> Program {
    Program { live: live_with(program, wanted), ..program.clone() }
}

/// The values that an iteration needs; they may stand in blocks before it.
pub(crate) fn iteration(blocks: &[Block], block: BlockId) -> Vec<Value> {
    match &blocks[block.index()].kind {
        BlockKind::Straight | BlockKind::ClosedForm(_) => Vec::new(),
        BlockKind::Newton(newton) => {
            let scalars =
                newton.scalars.iter().flat_map(|scalar| [scalar.first, scalar.now, scalar.next]);
            let columns = newton.columns.iter().flatten().filter(|_| newton.dense);
            scalars
                .chain(newton.gap.iter().copied())
                .chain(columns.copied())
                .chain([newton.det])
                .chain(newton.extent)
                .chain(newton.contracting_step())
                .collect()
        }
    }
}

/// The number of operations that may stand in one another.
const DEPTH: usize = 64;

impl Program {
    /// Gives names to values in the middle of long chains.
    pub(super) fn cut_chains(&mut self) {
        let mut uses = vec![0_usize; self.ssa.nodes.len()];
        for value in self.live_values() {
            for operand in self.node(value).op.operands() {
                uses[operand.index()] += 1;
            }
        }
        let mut depths = vec![0_usize; self.ssa.nodes.len()];
        for index in 0..self.ssa.nodes.len() {
            let node = &self.ssa.nodes[index];
            let leaf = matches!(node.op, Op::Constant(_) | Op::Last(_));
            if !self.live[index] || leaf || node.name.is_some() || uses[index] > 1 {
                continue;
            }
            let operands = node.op.operands().map(|operand| depths[operand.index()]);
            let depth = 1 + operands.max().unwrap_or(0);
            if depth < DEPTH {
                depths[index] = depth;
            } else {
                self.ssa.nodes[index].name = Some("part".to_owned());
            }
        }
    }
}
