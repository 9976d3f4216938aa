//! Loops that place links which are needed, but whose solution is not: where two slides follow each other, a link between them keeps
//! a direction that is known, and may be where it is whatever the displacements of the slides.

use crate::model::Model;
use crate::plan::Plan;
use crate::program::live::iteration;
use crate::program::node::{BlockId, Op, Slot, Value};
use crate::program::{BlockKind, Program};

impl Program {
    /// The loops, by number, whose solution does not reach any pose, while poses are numbered among those of all links.
    pub(super) fn idle_loops(&self, model: &Model, plan: &Plan) -> Vec<usize> {
        if model.show.is_none() {
            return Vec::new();
        }
        let reached = self.reached_loops();
        let blocks = self.block_ids().filter(|block| !reached.contains(block));
        let idle = blocks.filter_map(|block| self.loop_of(block));
        // The turns of what is tied are counted from move to move.
        let tied = |number: &usize| {
            plan.loops().nth(*number).is_some_and(|closing| !closing.ties.is_empty())
        };
        idle.filter(|number| !tied(number)).collect()
    }

    /// The blocks of loops that are needed: a pose depends on their solution, or the solution or the test of a needed loop does.
    fn reached_loops(&self) -> Vec<BlockId> {
        let mut found = vec![None; self.ssa.nodes.len()];
        for (block, closed) in self.closed_forms() {
            for value in &closed.found {
                // A value that was known before is not found by closing the loop.
                if self.node(*value).block == block {
                    found[value.index()] = Some(block);
                }
            }
        }
        let mut reached: Vec<BlockId> = Vec::new();
        let mut seen = vec![false; self.ssa.nodes.len()];
        let mut waiting: Vec<Value> = self.poses.iter().flatten().copied().collect();
        while let Some(value) = waiting.pop() {
            if std::mem::replace(&mut seen[value.index()], true) {
                continue;
            }
            let op = self.node(value).op;
            waiting.extend(op.operands());
            if let Op::Last(Slot::State(state)) = op {
                waiting.push(self.state[state]);
            }
            let solved = match op {
                Op::Solved(block, _) => Some(block),
                _ => found[value.index()],
            };
            if let Some(block) = solved.filter(|block| !reached.contains(block)) {
                reached.push(block);
                waiting.extend(iteration(&self.ssa.blocks, block));
                waiting.extend(self.closed_form(block).map(|closed| closed.margin));
                let watches = self.watches.iter().filter(|watch| watch.block == block);
                waiting.extend(
                    watches.flat_map(|watch| {
                        [self.state[watch.sine], self.state[watch.rounding_square]]
                    }),
                );
            }
        }
        reached
    }

    /// Makes the blocks of these loops straight: they place links, but solve nothing.
    pub(super) fn forget_loops(&mut self, idle: &[usize]) {
        for block in &mut self.ssa.blocks {
            if block.loop_number().is_some_and(|number| idle.contains(&number)) {
                block.kind = BlockKind::Straight;
            }
        }
    }
}
