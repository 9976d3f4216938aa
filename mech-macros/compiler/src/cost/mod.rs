//! The cost of a position: the operations of a program, counted, and weighed for a machine.

use crate::model::{Precision, Target, in_32_bits};
use crate::program::{Block, BlockId, BlockKind, Newton, Op, Program, Rounds, Value};
pub use mech_core::Cost;

/// The number of rounds that an iteration usually takes until its loop closes: from a step of a degree or so each round doubles the digits,
/// and the third finds nothing left to do.
const USUAL_ROUNDS: u32 = 3;

/// Cycles of each kind of operation, in the order in which [`Cost`] counts them: estimates.
///
/// A position is one long chain of operations of which about two at a time do not wait for each other. On a desktop machine (Skylake to
/// Zen 4: Fog's instruction tables) sums and products count half their latency of four; quotients and roots, which everything after them
/// waits for, count the whole of theirs; sines are those of `libm` on reduced arguments, as measured beside the dyad (`DESIGN.md`, §5). A
/// Cortex-M4 does one thing after the other. By its reference manual a sum or a product takes one cycle, and one more to load or store its
/// operands; a quotient or a root takes 14. What it has no unit for is a call: double precision as in the run-time libraries of compilers,
/// sines and arctangents by polynomials.
const fn cycles(target: Target, precision: Precision) -> [f64; 7] {
    match (target, precision) {
        (Target::X86_64, Precision::F64) => [2.0, 2.0, 14.0, 18.0, 40.0, 60.0, 1.0],
        (Target::X86_64, Precision::F32) => [2.0, 2.0, 11.0, 12.0, 30.0, 45.0, 1.0],
        (Target::CortexM4f, Precision::F32) => [2.0, 2.0, 14.0, 14.0, 60.0, 80.0, 3.0],
        (Target::CortexM4f, Precision::F64) => [70.0, 60.0, 250.0, 500.0, 2500.0, 2500.0, 20.0],
    }
}

/// About how many cycles operations take on a machine.
#[must_use]
pub fn weight(cost: Cost, target: Target, precision: Precision) -> f64 {
    let cycles = cycles(target, precision);
    let counts = cost.counts().map(f64::from);
    counts.iter().zip(cycles).map(|(count, one)| count * one).sum()
}

/// The cost of an operation. A cosine is counted with its sine, if that is needed too, which `sine` decides.
fn of_operation(op: Op, sine: impl Fn(Value) -> bool) -> Cost {
    let mut cost = Cost::NOTHING;
    match op {
        Op::Constant(_)
        | Op::Input(_)
        | Op::Turns(_)
        | Op::Last(_)
        | Op::Unknown(..)
        | Op::Solved(..)
        | Op::Dense(..)
        | Op::Time
        | Op::Rate(_)
        | Op::Acceleration(_)
        | Op::Load(_)
        | Op::Linear(..) => {}
        // A remainder of whole numbers, and a part of a turn.
        Op::PartOfTurns(..) => {
            cost.multiplications = 1;
            cost.divisions = 1;
        }
        Op::Neg(_) | Op::Add(..) | Op::Sub(..) => cost.additions = 1,
        Op::Mul(..) => cost.multiplications = 1,
        Op::Div(..) => cost.divisions = 1,
        Op::Sqrt(_) => cost.square_roots = 1,
        Op::Sin(_) => cost.sine_cosine_pairs = 1,
        Op::Cos(angle) => cost.sine_cosine_pairs = u32::from(!sine(angle)),
        Op::Atan2(..) | Op::Exp(_) => cost.arctangents = 1,
        // The step, the time in it, and a wave or a polynomial.
        Op::Stairs(..) => {
            cost.additions = 2;
            cost.divisions = 1;
            cost.selections = 3;
            cost.sine_cosine_pairs = 1;
        }
        Op::Abs(_) | Op::Max(..) | Op::CopySign(..) | Op::Choose(..) | Op::Round(_) => {
            cost.selections = 1;
        }
    }
    cost
}

/// A dense system of so many unknowns by elimination with pivoting, with its determinant: n³/3 products and sums and a bit.
fn of_dense(unknowns: usize) -> Cost {
    let n = in_32_bits(unknowns.min(1000));
    // In the column of each pivot the rest below it is compared, divided, and taken off row by row.
    let below = n * n.saturating_sub(1) / 2;
    let taken_off = n.saturating_sub(1) * n * (2 * n).saturating_sub(1) / 6;
    let products = taken_off + below + below;
    Cost {
        additions: products,
        multiplications: products + n,
        divisions: below + n,
        selections: below,
        ..Cost::NOTHING
    }
}

/// The cost of a whole program.
#[must_use]
pub fn of_program(program: &Program) -> Cost {
    of_blocks(program).into_iter().sum()
}

/// The cost of rates beyond that of a position.
#[must_use]
pub fn of_rates(program: &Program, moving: &Program) -> Cost {
    let systems = moving.live_systems().map(|system| of_dense(system.columns.len()));
    let tests = Cost { selections: in_32_bits(moving.rate_margins().len()), ..Cost::default() };
    let all: Cost = of_program(moving) + systems.sum() + tests;
    all.without(of_program(program))
}

/// The cost of each loop, in the order in which they are closed.
#[must_use]
pub fn of_loops(program: &Program) -> Vec<Cost> {
    let blocks = program.ssa.blocks.iter().zip(of_blocks(program));
    blocks
        .filter(|(block, _)| !matches!(block.kind, BlockKind::Straight))
        .map(|(_, cost)| cost)
        .collect()
}

/// The cost of each block. Of values that several need, the first pays.
#[must_use]
pub fn of_blocks(program: &Program) -> Vec<Cost> {
    let sine_of = sines(program);
    let mut costs = vec![Cost::default(); program.ssa.blocks.len()];
    let iterations: Vec<Option<Iteration>> = program
        .block_ids()
        .map(|block| {
            let newton = program.newton(block)?;
            Some(Iteration::of(program, block, newton))
        })
        .collect();
    for value in program.live_values() {
        let node = program.node(value);
        let once = of_operation(node.op, |angle| sine_of[angle.index()]);
        let times = match &iterations[node.block.index()] {
            Some(iteration) if node.iterated => iteration.times(value),
            _ => 1,
        };
        let cost = &mut costs[node.block.index()];
        *cost = *cost + once * times;
    }
    for ((block, iteration), cost) in program.ssa.blocks.iter().zip(&iterations).zip(&mut costs) {
        *cost = *cost + tests(program, block, iteration.as_ref());
    }
    costs
}

/// For each value whether its sine is needed.
fn sines(program: &Program) -> Vec<bool> {
    let mut sines = vec![false; program.ssa.nodes.len()];
    for value in program.live_values() {
        if let Op::Sin(angle) = program.node(value).op {
            sines[angle.index()] = true;
        }
    }
    sines
}

/// The cost of the test whether a loop is closed, and of the systems that are solved as a whole.
fn tests(program: &Program, block: &Block, iteration: Option<&Iteration>) -> Cost {
    let (newton, iteration) = match (&block.kind, iteration) {
        (BlockKind::Newton(newton), Some(iteration)) => (newton, iteration),
        (BlockKind::ClosedForm(closed), _) => {
            let may_fail = !matches!(program.node(closed.margin).op, Op::Constant(_));
            return Cost { selections: u32::from(may_fail), ..Cost::default() };
        }
        _ => return Cost::default(),
    };
    // The greatest of the gap against a limit, and the determinant against its floor.
    let gap = in_32_bits(newton.gap.len());
    let grown = u32::from(newton.extent.is_some());
    let test =
        Cost { additions: grown, multiplications: grown, selections: 2 * gap, ..Cost::default() };
    let in_rounds = match newton.rounds {
        Rounds::Exactly(_) => Cost::default(),
        Rounds::UntilClosed(_) => test * (iteration.rounds + 1),
    };
    let dense = if newton.dense {
        of_dense(newton.columns.len()) * (iteration.rounds + 1)
    } else {
        Cost::default()
    };
    let rounds = newton.contracting_step().map_or(0, |_| iteration.rounds);
    let contraction_and_det =
        Cost { multiplications: rounds, selections: 2 * rounds + 1, ..Cost::default() };
    in_rounds + dense + test + contraction_and_det
}

/// The number of times that the operations of an iteration run.
struct Iteration {
    rounds: u32,
    /// For each node whether the test of a round needs it, or a last step: that is done once more after the last round.
    measured: Vec<bool>,
}

impl Iteration {
    fn of(program: &Program, block: BlockId, newton: &Newton) -> Self {
        let rounds = match newton.rounds {
            Rounds::Exactly(rounds) => rounds,
            Rounds::UntilClosed(most) => most.min(USUAL_ROUNDS),
        };
        let columns = newton.columns.iter().flatten().filter(|_| newton.dense);
        let mut waiting: Vec<Value> = newton
            .gap
            .iter()
            .chain(columns)
            .copied()
            .chain([newton.det])
            .chain(newton.extent)
            .collect();
        let mut measured = vec![newton.steps_on(); program.ssa.nodes.len()];
        while let Some(value) = waiting.pop() {
            let node = program.node(value);
            let here = node.block == block && node.iterated;
            if here && !std::mem::replace(&mut measured[value.index()], true) {
                waiting.extend(node.op.operands());
            }
        }
        Self { rounds, measured }
    }

    fn times(&self, value: Value) -> u32 {
        self.rounds + u32::from(self.measured[value.index()])
    }
}

#[cfg(test)]
mod tests;
