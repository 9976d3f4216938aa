//! Enclosures of what a program computes: on boxes, and at places.

use super::Interval;
use super::carried::{find_held, made_from};
use super::claim::{Group, HeldValues, Test, carried_sides, tests};
use super::cone::Cutter;
use super::tape::{Outcome, Tape};
use crate::program::{BlockId, Op, Program, Value};
use std::collections::{BTreeMap, BTreeSet};

/// The loops on a box: how far they are known to close.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sight {
    /// All of them close everywhere.
    Closes,
    /// Some may not close somewhere.
    Open,
    /// One of them closes nowhere.
    Blocked,
}

/// Some values of a program, on boxes of motor values.
pub(crate) struct Enclosure<'p> {
    tape: Tape<'p>,
}

impl<'p> Enclosure<'p> {
    /// The values that are asked for, with these numbers of the state put in; nothing if one run would take too long. Each loop that
    /// carries its side has that of the start, or the other one if it is among `turned`.
    pub(crate) fn new(
        program: &'p Program,
        turned: &[BlockId],
        carried: &[(usize, Interval)],
        found: &[Value],
    ) -> Option<Self> {
        let tests = tests_of(program, found);
        let tape = Tape::asking(program, tests, turned, carried, found);
        (!tape.is_too_large()).then_some(Self { tape })
    }

    /// Follows staircases more closely.
    pub(crate) fn follow_stairs(&mut self) {
        self.tape.follow_stairs();
    }

    /// Runs it on a box.
    pub(crate) fn run(&mut self, place: &[Interval]) -> Sight {
        self.tape.run(place);
        let worst = (0..self.tape.tests()).map(|test| self.tape.on_box(test));
        match worst.max() {
            Some(Outcome::Fails) => Sight::Blocked,
            Some(Outcome::Open) => Sight::Open,
            Some(Outcome::Strict | Outcome::Passes) | None => Sight::Closes,
        }
    }

    /// Tests whether all loops close at the middle of the last box.
    pub(crate) fn closes_at_centre(&self) -> bool {
        let mut tests = 0..self.tape.tests();
        tests.all(|test| self.tape.at_centre(test) <= Outcome::Passes)
    }

    /// Tests whether these loops close everywhere on the last box, and stay clear of dead points and change points.
    pub(crate) fn is_clear(&self, blocks: &[BlockId]) -> bool {
        blocks.iter().all(|block| {
            let tests = 0..self.tape.tests();
            let mut own = tests.filter(|test| self.tape.block(*test) == Some(*block));
            let first = own.next();
            let is_clear = |test: usize| self.tape.on_box(test) == Outcome::Strict;
            first.is_some_and(is_clear) && own.all(is_clear)
        })
    }

    /// A value on the last box.
    pub(crate) fn on_box(&self, value: Value) -> Interval {
        self.tape.value(value)
    }

    /// A value at the middle of the last box.
    pub(crate) fn at_centre(&self, value: Value) -> Interval {
        self.tape.middle(value)
    }

    /// The mean of a value over the values of a motor on the last box, wherever the others are.
    pub(crate) fn mean(&self, value: Value, motor: usize) -> Interval {
        self.tape.mean(value, motor)
    }

    /// The cost of one run, in intervals.
    pub(crate) fn cost(&self) -> usize {
        self.tape.cost()
    }
}

/// The tests of the loops from which some values are computed.
fn tests_of(program: &Program, found: &[Value]) -> Vec<(BlockId, Test)> {
    let made_from = made_from(program, found.to_vec(), &HeldValues::new());
    let is_needed = |test: &Test| made_from.contains(&test.decided_by());
    let all = tests(program).into_iter();
    all.filter(|(_, test)| is_needed(test)).collect()
}

/// The origins of some values.
pub(crate) struct Sources {
    /// The inputs, by their numbers.
    pub(crate) inputs: Vec<usize>,
    /// Those of them that have a part in whether loops close.
    pub(crate) tested: Vec<usize>,
    /// The block that is iterated, if one is.
    pub(crate) iterated: Option<BlockId>,
    /// Whether they need more than three linear equations to be solved together.
    pub(crate) is_dense: bool,
    made_from: BTreeSet<Value>,
}

impl Sources {
    /// Finds the origins of some values.
    pub(crate) fn of(program: &Program, found: &[Value]) -> Self {
        let made_from = made_from(program, found.to_vec(), &HeldValues::new());
        let mut ops = made_from.iter().map(|value| program.node(*value).op);
        let iterated = ops.find_map(|op| match op {
            Op::Unknown(block, _) | Op::Solved(block, _) | Op::Dense(block, _) => Some(block),
            _ => None,
        });
        let mut ops = made_from.iter().map(|value| program.node(*value).op);
        let is_dense = ops.any(|op| matches!(op, Op::Linear(..)));
        let tested = tests_of(program, found);
        let tested = tested.iter().flat_map(|(_, test)| test.values());
        Self {
            inputs: motors(program, found.to_vec(), &HeldValues::new()),
            tested: motors(program, tested.collect(), &HeldValues::new()),
            iterated,
            is_dense,
            made_from,
        }
    }

    /// The values from which operations choose that have a corner or a jump.
    pub(crate) fn chosen(&self, program: &Program) -> Vec<Value> {
        let ops = self.made_from.iter().map(|value| program.node(*value).op);
        let choosing = ops.filter(|op| {
            matches!(
                op,
                Op::Abs(_)
                    | Op::Max(..)
                    | Op::Choose(..)
                    | Op::CopySign(..)
                    | Op::Round(_)
                    | Op::Stairs(..)
            )
        });
        let mut chosen: Vec<Value> = choosing.flat_map(Op::operands).collect();
        chosen.sort_unstable();
        chosen.dedup();
        chosen
    }

    /// Tests whether the values are computed from what this operation makes.
    pub(crate) fn read(&self, program: &Program, op: Op) -> bool {
        let mut values = self.made_from.iter();
        values.any(|value| program.node(*value).op == op)
    }

    /// Tests whether the values are computed from this one.
    pub(crate) fn contain(&self, value: Value) -> bool {
        self.made_from.contains(&value)
    }
}

/// The loops from which some values are computed and that carry their side, if motors may take them to the other one.
pub(crate) fn side_changes(
    program: &Program,
    found: &[Value],
    touching: Option<&[BlockId]>,
) -> Vec<BlockId> {
    let made_from = made_from(program, found.to_vec(), &HeldValues::new());
    let is_needed = |block: &BlockId| {
        let closed = program.closed_form(*block);
        closed.is_some_and(|closed| made_from.contains(&closed.discriminant))
    };
    let carriers = carried_sides(program).map(|(block, _)| block);
    let touches = |block: &BlockId| touching.is_none_or(|touching| touching.contains(block));
    carriers.filter(is_needed).filter(touches).collect()
}

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
