//! Long blocks in parts: every block becomes a function, and the Rust compiler nests a scope for every `let` of a function.

use super::node::{BlockId, Op, Value};
use super::{Block, BlockKind, Program, System};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// The number of `let`s in one part of a block that is divided.
const PART: usize = 256;

/// Values that are bound together, by one `let`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum LetGroup {
    /// Sine and cosine of an angle.
    Sines(Value),
    /// The results of a linear system.
    System(usize),
    /// Nothing else.
    Alone(Value),
}

impl Program {
    /// The same program with each straight block of more than so many `let`s in parts that follow each other. The operations are the
    /// same; those that have no name stand where their result is used.
    pub(crate) fn divide(&self, most: usize) -> Cow<'_, Self> {
        let lets = self.lets();
        let mut counts = vec![0_usize; self.ssa.blocks.len()];
        for value in self.live_values().filter(|value| lets[value.index()]) {
            counts[self.node(value).block.index()] += 1;
        }
        let is_straight = |block: &Block| matches!(block.kind, BlockKind::Straight);
        let is_long = |(block, &count): (&Block, &usize)| is_straight(block) && count > most;
        let long: Vec<bool> = self.ssa.blocks.iter().zip(&counts).map(is_long).collect();
        if !long.contains(&true) {
            return Cow::Borrowed(self);
        }
        let parts = self.parts(&lets, &long);
        Cow::Owned(self.in_parts(&parts))
    }

    /// For each value whether it is bound by a `let` where blocks are functions: it means something, it is not used just once, or not
    /// in its block.
    fn lets(&self) -> Vec<bool> {
        let mut uses = vec![0_usize; self.ssa.nodes.len()];
        let mut beyond = vec![false; self.ssa.nodes.len()];
        for value in self.live_values() {
            let block = self.node(value).block;
            for operand in self.read_by(value) {
                uses[operand.index()] += 1;
                beyond[operand.index()] |= self.node(operand).block != block;
            }
        }
        for value in self.roots() {
            beyond[value.index()] = true;
        }
        let is_let = |(index, node): (usize, &super::Node)| {
            let leaf = matches!(node.op, Op::Constant(_) | Op::Last(_));
            self.live[index] && !leaf && (node.name.is_some() || uses[index] != 1 || beyond[index])
        };
        self.ssa.nodes.iter().enumerate().map(is_let).collect()
    }

    /// The values that a value is made from, directly or by the system that gives it.
    fn read_by(&self, value: Value) -> impl Iterator<Item = Value> {
        let op = self.node(value).op;
        let system = match op {
            Op::Linear(number, _) => Some(&self.systems()[number]),
            _ => None,
        };
        let read = system.into_iter().flat_map(System::coefficients);
        op.operands().chain(read.copied())
    }

    /// For each value the part of its block in which it is made, counted from zero.
    fn parts(&self, lets: &[bool], long: &[bool]) -> Vec<usize> {
        let mut parts = vec![0; self.ssa.nodes.len()];
        let mut bound = vec![0_usize; self.ssa.blocks.len()];
        let mut known = BTreeMap::new();
        let is_in_long = |value: Value| long[self.node(value).block.index()];
        for value in self.live_values().filter(|&value| is_in_long(value) && lets[value.index()]) {
            let node = self.node(value);
            let together = match node.op {
                Op::Sin(angle) | Op::Cos(angle) => LetGroup::Sines(angle),
                Op::Linear(system, _) => LetGroup::System(system),
                _ => LetGroup::Alone(value),
            };
            parts[value.index()] = *known.entry(together).or_insert_with(|| {
                let bound = &mut bound[node.block.index()];
                *bound += 1;
                (*bound - 1) / PART
            });
        }
        // A value without a name stands in the part of its only use.
        let values: Vec<Value> = self.live_values().filter(|&value| is_in_long(value)).collect();
        for &value in values.iter().rev() {
            for operand in self.read_by(value) {
                let here = self.node(operand).block == self.node(value).block;
                if here && !lets[operand.index()] {
                    parts[operand.index()] = parts[value.index()];
                }
            }
        }
        parts
    }

    /// The same program with each block in these parts.
    fn in_parts(&self, parts: &[usize]) -> Self {
        let mut last = vec![0; self.ssa.blocks.len()];
        for value in self.live_values() {
            let last = &mut last[self.node(value).block.index()];
            *last = parts[value.index()].max(*last);
        }
        let mut divided = self.clone();
        divided.ssa.blocks.clear();
        // Where the parts of each block begin among all.
        let mut first = Vec::new();
        for (block, &last) in self.ssa.blocks.iter().zip(&last) {
            first.push(divided.ssa.blocks.len());
            divided.ssa.blocks.extend((0..=last).map(|_| block.clone()));
        }
        let renumbered = |block: BlockId, part: usize| BlockId::at(first[block.index()] + part);
        for (node, &part) in divided.ssa.nodes.iter_mut().zip(parts) {
            node.block = renumbered(node.block, part);
            if let Op::Unknown(block, _) | Op::Solved(block, _) | Op::Dense(block, _) = &mut node.op
            {
                *block = renumbered(*block, 0);
            }
        }
        for watch in &mut divided.watches {
            watch.block = renumbered(watch.block, 0);
        }
        let mut solved = BTreeMap::new();
        for value in self.live_values() {
            if let Op::Linear(system, _) = self.node(value).op {
                solved.insert(system, parts[value.index()]);
            }
        }
        let systems = divided.derived.iter_mut().flat_map(|derived| &mut derived.equations.systems);
        for (number, system) in systems.enumerate() {
            // A system that nothing reads may stand anywhere.
            let part = solved.get(&number).copied().unwrap_or(0);
            system.block = renumbered(system.block, part);
        }
        divided
    }
}
