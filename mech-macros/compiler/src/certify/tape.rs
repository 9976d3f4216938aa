//! A program run on a box: every value as an interval, and how much it changes from the middle of the box.
//!
//! Beside its natural interval each value has its interval at the middle and, for each motor, an interval of slopes s such
//! that f(x) − f(middle) is the sum of s · (x − middle). What both ways of bounding it leave is kept: the slopes see how
//! values depend on one another, which is what makes chains of loops provable.

use super::Interval;
use crate::program::{BlockId, Op, Program, Slot, Value};

/// What must hold for a loop to close, by the values that tell.
#[derive(Clone, Copy, Debug)]
pub(super) enum Test {
    /// This slack is not less than zero by more than this floor.
    Slack(Value, Value),
    /// This divisor is not zero.
    Divisor(Value),
}

/// What is known about a test on a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Outcome {
    /// It passes everywhere, by more than rounding.
    Strict,
    /// It passes everywhere.
    Passes,
    /// Nobody knows.
    Open,
    /// It fails everywhere.
    Fails,
}

/// A program that is run on boxes.
#[derive(Clone, Debug)]
pub(super) struct Tape<'p> {
    program: &'p Program,
    motors: usize,
    /// What depends on motors, in order; all other values are known once and for all.
    moving: Vec<Value>,
    tests: Vec<(BlockId, Test)>,
    values: Vec<Interval>,
    middles: Vec<Interval>,
    /// For each value as many as there are motors.
    slopes: Vec<Interval>,
    offsets: Vec<Interval>,
    centre: Vec<f64>,
    evaluations: usize,
}

impl<'p> Tape<'p> {
    /// The loops of a program that do not hang on an iteration, each of those that carry their side on that of the start, or, if
    /// they are among `turned`, on the other.
    pub(super) fn new(program: &'p Program, turned: &[BlockId]) -> Self {
        let count = program.nodes.len();
        let motors = program.motors.len();
        let mut tape = Self {
            program,
            motors,
            moving: Vec::new(),
            tests: tests(program),
            values: vec![Interval::ENTIRE; count],
            middles: vec![Interval::ENTIRE; count],
            slopes: vec![Interval::ZERO; count * motors],
            offsets: vec![Interval::ZERO; motors],
            centre: vec![0.0; motors],
            evaluations: 0,
        };
        for (block, closed) in program.all_closed() {
            if let Some(kept) = closed.kept {
                let side = program.start.kept.get(kept).copied().unwrap_or(1.0);
                let side = 1.0_f64.copysign(side) * if turned.contains(&block) { -1.0 } else { 1.0 };
                tape.keep(kept, Interval::point(side));
            }
        }
        tape.sort();
        tape
    }

    /// What is carried in this place.
    fn keep(&mut self, kept: usize, carried: Interval) {
        for (index, node) in self.program.nodes.iter().enumerate() {
            if node.op == Op::Last(Slot::Kept(kept)) {
                self.values[index] = carried;
                self.middles[index] = carried;
            }
        }
    }

    /// Finds what tests need, and does what can be done once and for all.
    fn sort(&mut self) {
        let nodes = &self.program.nodes;
        let mut needed: Vec<Option<Value>> = vec![None; nodes.len()];
        for (_, test) in &self.tests {
            match *test {
                Test::Slack(slack, floor) => {
                    needed[slack.index()] = Some(slack);
                    needed[floor.index()] = Some(floor);
                }
                Test::Divisor(divisor) => needed[divisor.index()] = Some(divisor),
            }
        }
        for index in (0..nodes.len()).rev() {
            if needed[index].is_some() {
                for operand in nodes[index].op.operands() {
                    needed[operand.index()] = Some(operand);
                }
            }
        }
        let mut moves = vec![false; nodes.len()];
        for value in needed.into_iter().flatten() {
            let op = nodes[value.index()].op;
            let moving = matches!(op, Op::Motor(_)) || op.operands().any(|operand| moves[operand.index()]);
            moves[value.index()] = moving;
            if moving {
                self.moving.push(value);
            } else if let Some(known) = natural(op, |operand| self.values[operand.index()]) {
                self.values[value.index()] = known;
                self.middles[value.index()] = known;
            }
        }
    }

    /// How many tests there are.
    pub(super) fn tests(&self) -> usize {
        self.tests.len()
    }

    /// The block to which a test belongs.
    pub(super) fn block(&self, test: usize) -> Option<BlockId> {
        self.tests.get(test).map(|(block, _)| *block)
    }

    /// How many values and slopes were found so far.
    pub(super) fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// How many values and slopes are found in one run.
    pub(super) fn cost(&self) -> usize {
        self.moving.len() * (1 + self.motors)
    }

    /// The middle of the box on which it was run last.
    pub(super) fn centre(&self) -> &[f64] {
        &self.centre
    }

    /// Runs it on a box: for each motor an interval.
    pub(super) fn run(&mut self, range: &[Interval]) {
        self.evaluations += self.cost();
        for motor in 0..self.motors {
            let range = range.get(motor).copied().unwrap_or(Interval::ENTIRE);
            self.centre[motor] = range.middle();
            self.offsets[motor] = range - Interval::point(self.centre[motor]);
        }
        for step in 0..self.moving.len() {
            let value = self.moving[step];
            let index = value.index();
            let op = self.program.nodes[index].op;
            if let Op::Motor(motor) = op {
                self.values[index] = range.get(motor).copied().unwrap_or(Interval::ENTIRE);
                self.middles[index] = Interval::point(self.centre[motor]);
                self.slopes[index * self.motors + motor] = Interval::ONE;
                continue;
            }
            let value = |operand: Value| self.values[operand.index()];
            let middle = |operand: Value| self.middles[operand.index()];
            let by_value = natural(op, value).unwrap_or(Interval::ENTIRE);
            let by_middle = natural(op, middle).unwrap_or(Interval::ENTIRE);
            let shares = shares(op, value, middle, by_middle);
            let mut by_slope = by_middle;
            for motor in 0..self.motors {
                let mut slope = Interval::ZERO;
                for (operand, share) in shares.into_iter().flatten() {
                    let part = self.slopes[operand.index() * self.motors + motor];
                    if part != Interval::ZERO {
                        slope = slope + share * part;
                    }
                }
                self.slopes[index * self.motors + motor] = slope;
                by_slope = by_slope + slope * self.offsets[motor];
            }
            self.values[index] = by_value.meet(by_slope);
            self.middles[index] = by_middle;
        }
    }

    /// What is known about a test on the box on which it was run last.
    pub(super) fn on_box(&self, test: usize) -> Outcome {
        self.outcome(test, &self.values)
    }

    /// What is known about a test at the middle of that box.
    pub(super) fn at_centre(&self, test: usize) -> Outcome {
        self.outcome(test, &self.middles)
    }

    /// Whether a slack is not negative at the middle of that box, as far as that can be told.
    pub(super) fn closes_at_centre(&self, test: usize) -> bool {
        match self.tests[test].1 {
            Test::Slack(slack, _) => self.middles[slack.index()].middle() >= 0.0,
            Test::Divisor(_) => true,
        }
    }

    fn outcome(&self, test: usize, values: &[Interval]) -> Outcome {
        let (slack, floor) = match self.tests[test].1 {
            Test::Slack(slack, floor) => (values[slack.index()], values[floor.index()]),
            Test::Divisor(divisor) => {
                return if values[divisor.index()].contains(0.0) {
                    Outcome::Open
                } else {
                    Outcome::Strict
                };
            }
        };
        // The slack at run time differs by its own rounding, for which half the floor is enough.
        let enough = if floor.low() >= 0.0 {
            -0.5 * floor.low()
        } else {
            -2.0 * floor.low()
        };
        if slack.low() > floor.abs().high().max(enough) {
            Outcome::Strict
        } else if slack.low() >= enough {
            Outcome::Passes
        } else if slack.high() < -floor.high() {
            Outcome::Fails
        } else {
            Outcome::Open
        }
    }
}

/// What must hold for the loops to close that do not hang on an iteration, in the order in which they are found.
fn tests(program: &Program) -> Vec<(BlockId, Test)> {
    let mut hangs = vec![false; program.nodes.len()];
    let mut divisors = Vec::new();
    for (index, node) in program.nodes.iter().enumerate() {
        hangs[index] = matches!(
            node.op,
            Op::Unknown(..) | Op::Solved(..) | Op::Dense(..) | Op::Last(Slot::Pose(..))
        ) || node.op.operands().any(|operand| hangs[operand.index()]);
        if let Op::Div(_, by) = node.op
            && program.live.get(index) == Some(&true)
            && !matches!(program.node(by).op, Op::Constant(_))
            && !hangs[by.index()]
        {
            divisors.push((node.block, Test::Divisor(by)));
        }
    }
    let slacks = program
        .margins()
        .filter(|(_, closed)| !hangs[closed.margin.index()])
        .map(|(block, closed)| (block, Test::Slack(closed.slack, closed.floor)));
    let mut tests: Vec<(BlockId, Test)> = slacks.chain(divisors).collect();
    // Of each block first the slack: what is divided by may be zero only where it does not close.
    tests.sort_by_key(|(block, _)| *block);
    tests
}

/// The operation on intervals, if it is arithmetic; the others come from outside.
fn natural(op: Op, get: impl Fn(Value) -> Interval) -> Option<Interval> {
    Some(match op {
        Op::Constant(number) => Interval::point(number.get()),
        Op::Motor(_) | Op::Last(_) | Op::Unknown(..) | Op::Solved(..) | Op::Dense(..) => {
            return None;
        }
        Op::Neg(a) => -get(a),
        Op::Abs(a) => get(a).abs(),
        Op::Sqrt(a) => get(a).sqrt(),
        Op::Add(a, b) => get(a) + get(b),
        Op::Sub(a, b) => get(a) - get(b),
        Op::Mul(a, b) if a == b => get(a).square(),
        Op::Mul(a, b) => get(a) * get(b),
        Op::Div(a, b) => get(a) / get(b),
        Op::Sin(a) => get(a).sin(),
        Op::Cos(a) => get(a).cos(),
        Op::Max(a, b) => get(a).max(get(b)),
        Op::CopySign(a, b) => get(a).copysign(get(b)),
        Op::Atan2(a, b) => get(a).atan2(get(b)),
        Op::Round(a) => get(a).round(),
    })
}

/// How much each operand's change contributes to that of the result: op(x) − op(middle) is the sum of share · (operand(x) −
/// operand(middle)), wherever in the box x is.
fn shares(
    op: Op,
    value: impl Fn(Value) -> Interval,
    middle: impl Fn(Value) -> Interval,
    result: Interval,
) -> [Option<(Value, Interval)>; 2] {
    let one = Interval::ONE;
    let unknown = |a| Some((a, Interval::ENTIRE));
    match op {
        Op::Constant(_)
        | Op::Motor(_)
        | Op::Last(_)
        | Op::Unknown(..)
        | Op::Solved(..)
        | Op::Dense(..) => [None, None],
        Op::Neg(a) => [Some((a, -one)), None],
        Op::Abs(a) => [Some((a, sign(value(a)))), None],
        // √x − √m = (x − m) / (√x + √m): finite though x may be zero, if m is not.
        Op::Sqrt(a) => [Some((a, one / (value(a).sqrt() + result))), None],
        Op::Add(a, b) => [Some((a, one)), Some((b, one))],
        Op::Sub(a, b) => [Some((a, one)), Some((b, -one))],
        Op::Mul(a, b) if a == b => [Some((a, value(a) + middle(a))), None],
        Op::Mul(a, b) => [Some((a, value(b))), Some((b, middle(a)))],
        Op::Div(a, b) => {
            let inverse = one / value(b);
            [Some((a, inverse)), Some((b, -(result * inverse)))]
        }
        Op::Sin(a) => [Some((a, value(a).cos())), None],
        Op::Cos(a) => [Some((a, -value(a).sin())), None],
        Op::Max(a, b) => {
            let (first, second) = (value(a), value(b));
            if first.low() >= second.high() {
                [Some((a, one)), None]
            } else if second.low() >= first.high() {
                [Some((b, one)), None]
            } else {
                let part = Interval::ZERO.hull(one);
                [Some((a, part)), Some((b, part))]
            }
        }
        Op::CopySign(a, b) => {
            let (size, side) = (value(a), value(b));
            if side.contains(0.0) {
                [unknown(a), unknown(b)]
            } else {
                [Some((a, sign(size) * sign(side))), None]
            }
        }
        Op::Atan2(a, b) => {
            let (y, x) = (value(a), value(b));
            if x.low() <= 0.0 && y.contains(0.0) {
                [unknown(a), unknown(b)]
            } else {
                let inverse = one / (x.square() + y.square());
                [Some((a, x * inverse)), Some((b, -(y * inverse)))]
            }
        }
        Op::Round(a) => [unknown(a), None],
    }
}

/// The rate of the absolute value.
fn sign(of: Interval) -> Interval {
    if of.low() >= 0.0 {
        Interval::ONE
    } else if of.high() <= 0.0 {
        -Interval::ONE
    } else {
        Interval::ONE.hull(-Interval::ONE)
    }
}
