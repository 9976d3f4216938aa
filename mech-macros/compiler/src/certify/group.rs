//! Loops that hang on the same motors are proved together, over these motors alone: what is on the boom of a digger does not care how
//! the boom stands.

use super::carried::{find_held, made_from};
use super::claim::{Group, HeldValues, tests};
use super::cone::Cutter;
use crate::program::{BlockId, Op, Program, Value};
use std::collections::{BTreeMap, BTreeSet};

/// The tests of a program by their motors, the groups in the order of their first tests: all but those of loops that are free.
pub(super) fn groups(program: &Program, free: &[BlockId]) -> Vec<Group> {
    let cutter = Cutter::new(program);
    let mut groups: Vec<Group> = Vec::new();
    let mut loops: BTreeMap<BlockId, HeldValues> = BTreeMap::new();
    let tests = tests(program).into_iter();
    for (block, test) in tests.filter(|(block, _)| !free.contains(block)) {
        let held = loops.entry(block).or_insert_with(|| {
            let closed = program.closed_form(block);
            closed.map_or_else(HeldValues::new, |closed| find_held(&cutter, closed))
        });
        let motors = motors(program, test.values(), held);
        let same = |group: &&mut Group| group.motors == motors && group.held == *held;
        match groups.iter_mut().find(same) {
            Some(group) => group.tests.push((block, test)),
            None => groups.push(Group { motors, held: held.clone(), tests: vec![(block, test)] }),
        }
    }
    groups
}

/// The motors that have a part in a loop, by their numbers.
pub(crate) fn motors_of(program: &Program, block: BlockId) -> Vec<usize> {
    let values = program.ssa.nodes.iter().enumerate();
    let own = values.filter(|(_, node)| node.block == block);
    let own = own.map(|(index, _)| Value::at(index)).collect();
    motors(program, own, &HeldValues::new())
}

/// The motors from which some values are computed, but for those that are held.
pub(super) fn motors(program: &Program, values: Vec<Value>, held: &HeldValues) -> Vec<usize> {
    let values = made_from(program, values, held).into_iter();
    let motors: BTreeSet<usize> = values
        .filter_map(|value| match program.node(value).op {
            Op::Input(input) => Some(input.index()),
            _ => None,
        })
        .collect();
    motors.into_iter().collect()
}
