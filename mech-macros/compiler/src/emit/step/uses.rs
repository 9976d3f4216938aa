//! The number of uses of values: a value that is used more than once gets a name.

use crate::program::{BlockId, Program, Value};
use std::collections::BTreeMap;

/// The number of uses of each value, where all blocks stand in one function.
pub(super) fn all_uses(program: &Program) -> BTreeMap<Value, usize> {
    let mut all = uses_in(program, |_| true);
    let margins = program.margins().map(|(_, closed)| closed.margin);
    for value in program.roots().chain(margins) {
        *all.entry(value).or_insert(0) += 1;
    }
    all
}

/// The number of uses of each value within a block.
pub(super) fn uses(program: &Program, block: BlockId) -> BTreeMap<Value, usize> {
    uses_in(program, |other| other == block)
}

/// The number of uses of each value within some blocks.
fn uses_in(program: &Program, is_in: impl Fn(BlockId) -> bool) -> BTreeMap<Value, usize> {
    let mut uses = BTreeMap::new();
    let mut count = |value: Value| *uses.entry(value).or_insert(0) += 1;
    let nodes = program.live_values().map(|value| program.node(value));
    for node in nodes.filter(|node| is_in(node.block)) {
        node.op.operands().for_each(&mut count);
    }
    let systems = program.live_systems();
    for system in systems.filter(|system| is_in(system.block)) {
        system.coefficients().copied().for_each(&mut count);
    }
    let blocks = program.block_ids().filter(|block| is_in(*block));
    for newton in blocks.filter_map(|block| program.newton(block)) {
        // The gap and the determinant leave the iteration; the next values are read once.
        let columns = newton.columns.iter().flatten();
        let columns = columns.filter(|_| newton.dense);
        let gap = newton.gap.iter().copied();
        gap.chain([newton.det]).chain(newton.extent).chain(columns.copied()).for_each(&mut count);
        let scalars = newton.scalars.iter();
        scalars.flat_map(|scalar| [scalar.first, scalar.next]).for_each(&mut count);
    }
    uses
}
