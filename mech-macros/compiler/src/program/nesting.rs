//! Long chains of operations are cut into pieces with names. An expression that nests thousands of brackets would overflow the
//! stack of the Rust compiler, and nobody could read it.

use super::Program;
use super::node::Op;

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
