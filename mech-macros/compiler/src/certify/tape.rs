//! A program run on a box: every value as an interval and as an affine form. What both ways of bounding it leave is kept.

use super::Interval;
use super::WholeAngle;
use super::claim::{Group, Test, carried_sides, keeps_direction};
use super::form::{Forms, Linear, Operand, greater, root, wave};
use super::operation::{direction, natural, sign, strict_sign};
use super::stairs;
use crate::cancel;
use crate::program::{BlockId, Node, Op, Program, Slot, Value};
use mech_core::Staircase;

/// A program whose single run costs more is not proved at all.
const MOST: usize = 100_000;

/// The result of a test on a box.
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
    nodes: &'p [Node],
    motors: usize,
    /// The values that depend on motors, in order; all others are known once and for all.
    moving: Vec<Value>,
    tests: Vec<(BlockId, Test)>,
    /// Which values are directions, whatever they are made from.
    directions: Vec<bool>,
    /// Which values do not change.
    held: Vec<bool>,
    values: Vec<Interval>,
    /// The same in the middle of the box.
    middles: Vec<Interval>,
    /// Which step makes a value, if it depends on motors.
    steps: Vec<Option<usize>>,
    /// The angles over whole turns whose references are known.
    wholes: Vec<WholeAngle>,
    forms: Forms,
    /// Whether staircases have forms, as laws of the time need.
    climbs: bool,
    centre: Vec<f64>,
    evaluations: usize,
}

impl<'p> Tape<'p> {
    /// The tests of one group of a program. Each loop that carries its side has the side of the start, or the other one if it is among
    /// `turned`.
    pub(super) fn new(program: &'p Program, group: &Group, turned: &[BlockId]) -> Self {
        let directions = keeps_direction(program);
        let tests = group.tests.clone();
        let mut tape = Self::on(&program.ssa.nodes, program.inputs(), tests, directions);
        for &(value, at) in &group.held {
            tape.hold(value, Interval::point(at));
        }
        tape.choose_sides(program, turned);
        tape.sort(&[]);
        tape
    }

    /// The values that a program is asked for, with tests beside them; what is carried is put into it, and each loop that carries its side
    /// has that of the start, or the other one if it is among `turned`.
    pub(super) fn asking(
        program: &'p Program,
        tests: Vec<(BlockId, Test)>,
        turned: &[BlockId],
        carried: &[(usize, Interval)],
        found: &[Value],
    ) -> Self {
        let directions = keeps_direction(program);
        let mut tape = Self::on(&program.ssa.nodes, program.inputs(), tests, directions);
        tape.choose_sides(program, turned);
        for &(state, value) in carried {
            tape.set_state(state, value);
            tape.wholes.extend(WholeAngle::carried(program, state, value));
        }
        tape.sort(found);
        tape
    }

    /// A tape of nodes that are no whole program: with its tests, and other values that are to be found.
    pub(super) fn of(
        nodes: &'p [Node],
        inputs: usize,
        tests: Vec<(BlockId, Test)>,
        found: &[Value],
    ) -> Self {
        let mut tape = Self::on(nodes, inputs, tests, vec![false; nodes.len()]);
        tape.sort(found);
        tape
    }

    fn on(
        nodes: &'p [Node],
        motors: usize,
        tests: Vec<(BlockId, Test)>,
        directions: Vec<bool>,
    ) -> Self {
        Self {
            nodes,
            motors,
            moving: Vec::new(),
            tests,
            directions,
            held: vec![false; nodes.len()],
            values: vec![Interval::ENTIRE; nodes.len()],
            middles: vec![Interval::ENTIRE; nodes.len()],
            steps: vec![None; nodes.len()],
            wholes: Vec::new(),
            forms: Forms::new(motors, 0),
            climbs: false,
            centre: vec![0.0; motors],
            evaluations: 0,
        }
    }

    /// Puts each loop that carries its side on that of the start, or the other one if it is among `turned`.
    fn choose_sides(&mut self, program: &Program, turned: &[BlockId]) {
        for (block, state) in carried_sides(program) {
            let side = program.start.state[state];
            let turn = if turned.contains(&block) { -1.0 } else { 1.0 };
            self.set_state(state, Interval::point(1.0_f64.copysign(turn * side)));
        }
    }

    /// Gives forms to staircases, too.
    pub(super) fn follow_stairs(&mut self) {
        self.climbs = true;
    }

    /// Sets the state that is carried under this number.
    fn set_state(&mut self, state: usize, carried: Interval) {
        for (index, node) in self.nodes.iter().enumerate() {
            if node.op == Op::Last(Slot::State(state)) {
                self.values[index] = carried;
                self.middles[index] = carried;
            }
        }
    }

    /// A value that does not change, whatever it is made from.
    fn hold(&mut self, value: Value, at: Interval) {
        self.held[value.index()] = true;
        self.values[value.index()] = at;
        self.middles[value.index()] = at;
    }

    /// Finds what tests need, and what else is asked for; does what can be done once and for all.
    fn sort(&mut self, found: &[Value]) {
        cancel::check();
        let nodes = self.nodes;
        let mut needed: Vec<Option<Value>> = vec![None; nodes.len()];
        for &value in found {
            needed[value.index()] = Some(value);
        }
        for (_, test) in &self.tests {
            match *test {
                Test::Discriminant(discriminant, tolerance) => {
                    needed[discriminant.index()] = Some(discriminant);
                    needed[tolerance.index()] = Some(tolerance);
                }
                Test::Divisor(divisor) => needed[divisor.index()] = Some(divisor),
            }
        }
        for index in (0..nodes.len()).rev() {
            if needed[index].is_some() && !self.held[index] {
                for operand in nodes[index].op.operands() {
                    needed[operand.index()] = Some(operand);
                }
            }
        }
        let mut moves = vec![false; nodes.len()];
        let needed = needed.into_iter().flatten();
        for value in needed.filter(|value| !self.held[value.index()]) {
            let op = nodes[value.index()].op;
            let moving =
                matches!(op, Op::Input(_)) || op.operands().any(|operand| moves[operand.index()]);
            moves[value.index()] = moving;
            if moving {
                self.steps[value.index()] = Some(self.moving.len());
                self.moving.push(value);
            } else if let Some(known) = natural(op, |operand| self.values[operand.index()]) {
                self.values[value.index()] = known;
                self.middles[value.index()] = known;
            }
        }
    }

    /// A value on the box on which it was run last.
    pub(super) fn value(&self, value: Value) -> Interval {
        self.values[value.index()]
    }

    /// Its mean over the values of a motor there, wherever the others are.
    pub(super) fn mean(&self, value: Value, motor: usize) -> Interval {
        let range = self.value(value);
        let step = self.steps[value.index()];
        step.map_or(range, |step| range.meet(self.forms.mean(step, motor)))
    }

    /// The same at the middle of that box.
    pub(super) fn middle(&self, value: Value) -> Interval {
        self.middles[value.index()]
    }

    /// Returns the number of tests.
    pub(super) fn tests(&self) -> usize {
        self.tests.len()
    }

    /// The block to which a test belongs.
    pub(super) fn block(&self, test: usize) -> Option<BlockId> {
        self.tests.get(test).map(|(block, _)| *block)
    }

    /// Returns the number of intervals that were computed so far.
    pub(super) fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// Returns the cost of one run, in intervals: a part of a form counts as a sixteenth of one.
    pub(super) fn cost(&self) -> usize {
        let steps = self.moving.len();
        steps * (4 + (self.motors + steps / 2) / 16)
    }

    /// Whether one run would take milliseconds, and the forms too much space: some fifty loops.
    pub(super) fn is_too_large(&self) -> bool {
        self.cost() > MOST
    }

    /// The middle of the box on which it was run last.
    pub(super) fn centre(&self) -> &[f64] {
        &self.centre
    }

    /// Runs it on a box: for each motor an interval.
    pub(super) fn run(&mut self, range: &[Interval]) {
        cancel::check();
        // Most tapes are only run at places, which takes no forms: these grow with the square of the steps.
        if !self.forms.are_of(self.moving.len()) {
            self.forms = Forms::new(self.motors, self.moving.len());
        }
        self.evaluations += self.cost();
        for (centre, range) in self.centre.iter_mut().zip(range) {
            *centre = range.middle();
        }
        for step in 0..self.moving.len() {
            let value = self.moving[step];
            let op = self.nodes[value.index()].op;
            let (by_value, by_middle) = match op {
                Op::Input(input) => {
                    let motor = input.index();
                    let range = range[motor];
                    self.forms.motor(step, motor, range);
                    (range, Interval::point(self.centre[motor]))
                }
                _ => (self.by_value(step, value), self.by_middle(value)),
            };
            self.values[value.index()] = by_value;
            self.middles[value.index()] = by_middle;
        }
    }

    /// Runs it at one place, where intervals alone are as narrow as rounding: forms would tell nothing more.
    pub(super) fn run_at(&mut self, place: &[f64]) {
        cancel::check();
        for step in 0..self.moving.len() {
            let value = self.moving[step];
            self.values[value.index()] = match self.nodes[value.index()].op {
                Op::Input(input) => Interval::point(place[input.index()]),
                _ => self.natural(value, &self.values),
            };
        }
    }

    fn by_middle(&self, value: Value) -> Interval {
        self.natural(value, &self.middles)
    }

    /// An operation on intervals.
    fn natural(&self, value: Value, values: &[Interval]) -> Interval {
        let op = self.nodes[value.index()].op;
        // Of what comes from outside nothing is known.
        let range = natural(op, |operand| values[operand.index()]).unwrap_or(Interval::ENTIRE);
        match op {
            Op::Add(..) => match self.wholes.iter().find(|whole| whole.is(value)) {
                Some(whole) => whole.range(values),
                None => range,
            },
            Op::Choose(test, ..)
                if self.directions[value.index()] && values[test.index()].low() < 0.0 =>
            {
                range.meet(direction())
            }
            _ => range,
        }
    }

    /// All values of an operation, as far as its natural interval and its form both tell.
    fn by_value(&mut self, step: usize, value: Value) -> Interval {
        let op = self.nodes[value.index()].op;
        let range = self.natural(value, &self.values);
        let known = match self.linear(op) {
            Some((operands, linear)) => self.forms.combine(step, operands, linear),
            None => false,
        };
        if known {
            let by_form = self.forms.range(step);
            // A form that says so much less than the interval is worse than none.
            if by_form.width() <= 2.0 * range.width() {
                return range.meet(by_form);
            }
        }
        self.forms.fresh(step, range);
        range
    }

    /// An operation as a linear one, where it is nearly one.
    fn linear(&self, op: Op) -> Option<([Operand; 2], Linear)> {
        let operand = |value: Value| Operand {
            range: self.values[value.index()],
            step: self.steps[value.index()],
        };
        let simple = |factors: [f64; 2]| Linear { factors, remainder: Interval::ZERO };
        let one = |a: Value, linear: Linear| ([operand(a), operand(a)], linear);
        let two = |a: Value, b: Value, linear: Linear| ([operand(a), operand(b)], linear);
        Some(match op {
            Op::Neg(a) => one(a, simple([-1.0, 0.0])),
            Op::Add(a, b) => two(a, b, simple([1.0, 1.0])),
            Op::Sub(a, b) => two(a, b, simple([1.0, -1.0])),
            Op::Abs(a) => one(a, simple([sign(operand(a).range)?, 0.0])),
            Op::CopySign(a, b) => {
                let sign = sign(operand(a).range)? * strict_sign(operand(b).range)?;
                one(a, simple([sign, 0.0]))
            }
            Op::Sqrt(a) => one(a, root(operand(a).range)?),
            Op::Mul(a, b) if a == b => one(a, self.square(operand(a))),
            Op::Mul(a, b) => two(a, b, self.multiply(operand(a), operand(b))),
            Op::Div(a, b) => two(a, b, self.divide(operand(a), operand(b))?),
            Op::Sin(a) | Op::Cos(a) => {
                let angle = operand(a);
                let middle = self.forms.middle(angle);
                let point = Interval::point(middle);
                let (sin, cos, between) = (point.sin(), point.cos(), angle.range.hull(point));
                let about = match op {
                    Op::Sin(_) => [sin, cos, between.sin()],
                    _ => [cos, -sin, between.cos()],
                };
                one(a, wave(angle.range, middle, about))
            }
            Op::Max(a, b) => {
                let (first, second) = (operand(a), operand(b));
                if first.range.low() >= second.range.high() {
                    one(a, simple([1.0, 0.0]))
                } else if second.range.low() >= first.range.high() {
                    one(b, simple([1.0, 0.0]))
                } else {
                    match (first.step, second.step) {
                        (Some(_), None) => one(a, greater(first.range, second.range)?),
                        (None, Some(_)) => one(b, greater(second.range, first.range)?),
                        _ => return None,
                    }
                }
            }
            Op::Choose(test, a, b) => {
                let test = operand(test).range;
                if test.low() >= 0.0 {
                    one(a, simple([1.0, 0.0]))
                } else if test.high() < 0.0 {
                    one(b, simple([1.0, 0.0]))
                } else {
                    return None;
                }
            }
            Op::Stairs(stairs, a, share) if self.climbs => {
                one(a, self.climb(operand(a), stairs, share.get())?)
            }
            Op::Atan2(..)
            | Op::Round(_)
            | Op::Exp(_)
            | Op::Stairs(..)
            | Op::Time
            | Op::Constant(_)
            | Op::Input(_)
            | Op::Turns(_)
            | Op::PartOfTurns(..)
            | Op::Last(_)
            | Op::Unknown(..)
            | Op::Solved(..)
            | Op::Dense(..)
            | Op::Rate(_)
            | Op::Acceleration(_)
            | Op::Load(_)
            | Op::Linear(..) => return None,
        })
    }

    fn square(&self, a: Operand) -> Linear {
        let middle = Interval::point(self.forms.middle(a));
        Linear {
            factors: [2.0 * middle.low(), 0.0],
            remainder: (a.range - middle).square() - middle.square(),
        }
    }

    /// With the slopes in reach, a height is that at the middle and a slope times the way from there.
    fn climb(&self, a: Operand, stairs: Staircase, share: f64) -> Option<Linear> {
        let middle = Interval::point(self.forms.middle(a));
        let slopes = stairs::smooth_slopes(stairs, a.range.hull(middle), share)?;
        if !slopes.is_bounded() {
            return None;
        }
        let slope = Interval::point(slopes.middle());
        let height = stairs::heights(stairs, middle, share);
        Some(Linear {
            factors: [slope.low(), 0.0],
            remainder: height - slope * middle + (slopes - slope) * (a.range - middle),
        })
    }

    fn multiply(&self, a: Operand, b: Operand) -> Linear {
        let (first, second) = (self.forms.middle(a), self.forms.middle(b));
        let (p, q) = (Interval::point(first), Interval::point(second));
        Linear { factors: [second, first], remainder: (a.range - p) * (b.range - q) - p * q }
    }

    /// With any q, a / b is q + (a − q · b) / b, where a − q · b is small.
    fn divide(&self, a: Operand, b: Operand) -> Option<Linear> {
        let quotient = self.forms.middle(a) / self.forms.middle(b);
        let inverses = Interval::ONE / b.range;
        if !(quotient.is_finite() && inverses.is_bounded()) {
            return None;
        }
        let inverse = inverses.middle();
        let factors = [inverse, -(inverse * quotient)];
        let [q, m] = [quotient, inverse].map(Interval::point);
        let small = self.forms.difference(a, b, quotient);
        let rounding = (m * -q - Interval::point(factors[1])) * b.range;
        Some(Linear { factors, remainder: q + (inverses - m) * small + rounding })
    }

    /// Returns the result of a test on the box on which it was run last.
    pub(super) fn on_box(&self, test: usize) -> Outcome {
        self.outcome(test, &self.values)
    }

    /// Returns the result of a test at the middle of that box.
    pub(super) fn at_centre(&self, test: usize) -> Outcome {
        self.outcome(test, &self.middles)
    }

    /// Whether a slack is known so well on the box on which it was run last that a narrower box would tell no more.
    pub(super) fn is_sharp(&self, test: usize) -> bool {
        match self.tests[test].1 {
            Test::Discriminant(discriminant, tolerance) => {
                let tolerance = self.values[tolerance.index()].abs().low();
                self.values[discriminant.index()].width() <= 0.25 * tolerance
            }
            Test::Divisor(_) => false,
        }
    }

    /// Whether a slack is not negative at the middle of that box, as far as that can be told.
    pub(super) fn closes_at_centre(&self, test: usize) -> bool {
        match self.tests[test].1 {
            Test::Discriminant(discriminant, _) => {
                self.middles[discriminant.index()].middle() >= 0.0
            }
            Test::Divisor(_) => true,
        }
    }

    fn outcome(&self, test: usize, values: &[Interval]) -> Outcome {
        let (discriminant, tolerance) = match self.tests[test].1 {
            Test::Discriminant(discriminant, tolerance) => {
                (values[discriminant.index()], values[tolerance.index()])
            }
            Test::Divisor(divisor) => {
                return if values[divisor.index()].contains(0.0) {
                    Outcome::Open
                } else {
                    Outcome::Strict
                };
            }
        };
        // The slack at run time differs by its own rounding, for which half the floor is enough.
        let enough =
            if tolerance.low() >= 0.0 { -0.5 * tolerance.low() } else { -2.0 * tolerance.low() };
        if discriminant.low() > tolerance.abs().high().max(enough) {
            Outcome::Strict
        } else if discriminant.low() >= enough {
            Outcome::Passes
        } else if discriminant.high() < -tolerance.high() {
            Outcome::Fails
        } else {
            Outcome::Open
        }
    }
}

#[cfg(test)]
impl Tape<'_> {
    /// Returns the interval of each step, and that from its form alone.
    pub(super) fn all(&self) -> Vec<(Interval, Interval)> {
        let ranges =
            |(step, value): (usize, &Value)| (self.values[value.index()], self.forms.range(step));
        self.moving.iter().enumerate().map(ranges).collect()
    }
}
