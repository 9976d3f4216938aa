//! The conditions under which a program is never blocked.

use super::Interval;
use crate::plan::Dyad;
use crate::program::{AtZero, BlockId, Op, Program, Value, Watch};

/// A condition for a loop to close, with the values that decide it.
#[derive(Clone, Copy, Debug)]
pub(super) enum Test {
    /// This slack is not less than zero by more than this floor.
    Discriminant(Value, Value),
    /// This divisor is not zero.
    Divisor(Value),
}

impl Test {
    /// The value that is tested.
    pub(super) fn decided_by(self) -> Value {
        match self {
            Self::Discriminant(value, _) | Self::Divisor(value) => value,
        }
    }

    /// Returns the values that decide it.
    pub(super) fn values(self) -> Vec<Value> {
        match self {
            Self::Discriminant(discriminant, tolerance) => vec![discriminant, tolerance],
            Self::Divisor(divisor) => vec![divisor],
        }
    }
}

/// Values that are held where they are at the start.
pub(super) type HeldValues = Vec<(Value, f64)>;

/// Tests that are proved together, and the motors that have a part in them.
#[derive(Clone, Debug)]
pub(super) struct Group {
    /// By their numbers.
    pub(super) motors: Vec<usize>,
    /// Directions that carry these loops: they stand still.
    pub(super) held: HeldValues,
    /// In the order in which they are found.
    pub(super) tests: Vec<(BlockId, Test)>,
}

impl Group {
    /// These ranges, but a motor that has no part in the claim stands at its start.
    pub(super) fn ranges(&self, program: &Program, ranges: &[Interval]) -> Vec<Interval> {
        let all = ranges.iter().zip(&program.start.motors).enumerate();
        let range = |(motor, (range, start)): (usize, (&Interval, &f64))| {
            if self.motors.contains(&motor) { *range } else { Interval::point(*start) }
        };
        all.map(range).collect()
    }
}

/// Returns the conditions for the loops to close that depend on no iteration, in the order in which these are found.
pub(super) fn tests(program: &Program) -> Vec<(BlockId, Test)> {
    let mut hangs = vec![false; program.ssa.nodes.len()];
    for (index, node) in program.ssa.nodes.iter().enumerate() {
        hangs[index] = matches!(node.op, Op::Unknown(..) | Op::Solved(..) | Op::Dense(..))
            || node.op.operands().any(|operand| hangs[operand.index()]);
    }
    let exposed = find_exposed(program, &keeps_direction(program));
    let divisors = program.ssa.nodes.iter().enumerate().filter_map(|(index, node)| match node.op {
        Op::Div(_, by)
            if exposed[index]
                && !hangs[by.index()]
                && !matches!(program.node(by).op, Op::Constant(_)) =>
        {
            Some((node.block, Test::Divisor(by)))
        }
        _ => None,
    });
    let slacks = program
        .margins()
        .filter(|(_, closed)| !hangs[closed.margin.index()])
        .map(|(block, closed)| (block, Test::Discriminant(closed.discriminant, closed.tolerance)));
    let mut tests: Vec<(BlockId, Test)> = slacks.chain(divisors).collect();
    // Of each block first the slack: what is divided by may be zero only where it does not close.
    tests.sort_by_key(|(block, _)| *block);
    tests
}

/// Which values are a part of a direction that is found, or, where pins meet and none can be, is another.
pub(super) fn keeps_direction(program: &Program) -> Vec<bool> {
    let mut keeps = vec![false; program.ssa.nodes.len()];
    for (_, closed) in program.margins() {
        let directions = match closed.dyad {
            Dyad::TwoCircles { .. } => 4,
            Dyad::TurningLine { .. } => 2,
            Dyad::CircleAndLine { .. } | Dyad::TwoLines { .. } => 0,
        };
        for value in closed.found.iter().take(directions) {
            keeps[value.index()] = matches!(program.node(*value).op, Op::Choose(..));
        }
    }
    keeps
}

/// Which values reach anything that is asked for, and not only where another direction may stand in for them.
fn find_exposed(program: &Program, keeps: &[bool]) -> Vec<bool> {
    let mut exposed = vec![false; program.ssa.nodes.len()];
    let margins = program.margins().map(|(_, closed)| closed.margin);
    for root in program.poses.iter().flatten().chain(&program.state).copied().chain(margins) {
        exposed[root.index()] = true;
    }
    for index in (0..exposed.len()).rev() {
        if !exposed[index] {
            continue;
        }
        let op = program.ssa.nodes[index].op;
        let guarded = match op {
            Op::Choose(_, a, _) if keeps[index] => Some(a),
            _ => None,
        };
        for operand in op.operands().filter(|operand| Some(*operand) != guarded) {
            exposed[operand.index()] = true;
        }
    }
    exposed
}

/// The loops that carry on which side their dyad lies, and where they do.
pub(super) fn carried_sides(program: &Program) -> impl Iterator<Item = (BlockId, usize)> + '_ {
    let carries = |watch: &&Watch| watch.at_zero == AtZero::ChangeBranch;
    let place = |watch: &Watch| (watch.block, watch.sine);
    program.watches.iter().filter(carries).map(place)
}
