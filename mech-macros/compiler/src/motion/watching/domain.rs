//! The ranges of a cone's variables: whole turns of angles, declared ranges, and what earlier loops were proved to find.

use super::LoopProof;
use crate::certify::Interval;
use crate::certify::cone::{Cuts, Cutter, Variable};
use crate::model::{Model, MotorId};
use crate::plan::Solution;
use crate::program::{Op, Program, Value};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};

/// More turns than this are not looked through: budgets would not last.
const MOST_TURNS: i64 = 1 << 20;
/// No staircase is looked at that needs more turns for whole steps.
const MOST_PARTS: i32 = 64;
/// Numbers that differ less than by this part of them differ by rounding.
const ROUNDING: f64 = 1e-12;

/// The ranges of everything that a mechanism is moved by.
pub(crate) struct Domain<'a> {
    pub(super) model: &'a Model,
    pub(super) cutter: Cutter<'a>,
    /// The loops that a param has a part in.
    pub(super) varying: BTreeSet<usize>,
    /// The proof about each loop, by its number.
    pub(super) known: Vec<LoopProof>,
}

impl<'a> Domain<'a> {
    pub(crate) fn new(model: &'a Model, program: &'a Program, loops: usize) -> Self {
        Self {
            model,
            cutter: Cutter::new(program),
            varying: program.dependent_loops().into_iter().collect(),
            known: vec![LoopProof::default(); loops],
        }
    }

    /// A sum of constant parts of inputs, if an angle is one.
    pub(crate) fn parts(&self, angle: Value) -> Option<BTreeMap<usize, f64>> {
        self.cutter.parts(angle)
    }

    /// Returns the value of an input at the start.
    pub(crate) fn start(&self, input: usize) -> f64 {
        self.cutter.program.start.motors[input]
    }

    /// Whether anything of an input is read.
    pub(crate) fn reads(&self, read: &InputReads, input: usize) -> bool {
        let turns = |angle: &Value| {
            let parts = self.cutter.parts(*angle);
            parts.is_some_and(|parts| parts.contains_key(&input))
        };
        read.inputs.contains(&input) || read.angles.iter().any(turns)
    }

    /// All values of a motor or param, whole turns among them.
    pub(crate) fn of_input(&self, input: usize) -> Interval {
        let start = self.start(input);
        if let Some(motor) = self.model.motors.get(input) {
            return match motor.range {
                // The start was allowed a rounding beyond the end.
                Some(range) => Interval::new(range.low.min(start), range.high.max(start)),
                None => Interval::ENTIRE,
            };
        }
        let param = self.model.params.ids().nth(input - self.model.motors.len());
        match param.and_then(|param| self.model.param_scale(param)) {
            Some(scale) => Interval::new(start - 0.5 * scale, start + scale),
            None => Interval::point(start),
        }
    }

    /// Whether a motor turns.
    pub(super) fn turns(&self, input: usize) -> bool {
        input < self.model.motors.len() && {
            let motor = self.model.motor(MotorId::new(input));
            self.model.turns(motor.joint)
        }
    }

    /// All values of a variable, known only from what kind of variable it is.
    pub(super) fn of_variable(&self, variable: Variable) -> Interval {
        match variable {
            Variable::Angle(angle) => self.of_angle(angle),
            Variable::Found(number, index) => {
                let range = self.known.get(number).and_then(|known| known.range(index));
                range.unwrap_or_else(|| match self.solution(number, index) {
                    Some(Solution::Direction(_)) => whole_turn(),
                    _ => Interval::ENTIRE,
                })
            }
            Variable::Input(input) => self.of_input(input),
        }
    }

    /// A whole turn, or less where the motors that make an angle have ranges.
    fn of_angle(&self, angle: Value) -> Interval {
        let Some(parts) = self.cutter.parts(angle) else {
            return whole_turn();
        };
        let moved = |(input, part): (&usize, &f64)| {
            let from = Interval::point(self.start(*input));
            Interval::point(*part) * (self.of_input(*input) - from)
        };
        let moved = parts.iter().map(moved).reduce(|sum, next| sum + next);
        // An angle that depends on no input does not move.
        let moved = moved.unwrap_or(Interval::ZERO);
        if moved.is_bounded() && moved.width() < TAU {
            Interval::point(self.cutter.at_start[angle.index()]) + moved
        } else {
            whole_turn()
        }
    }

    /// The angle of a direction at the start, as the program has it; zero for what is none.
    pub(super) fn angle_at_start(&self, solution: &Solution<Value>) -> f64 {
        let values = &self.cutter.at_start;
        match *solution {
            Solution::Direction([cos, sin]) => values[sin.index()].atan2(values[cos.index()]),
            Solution::Slide(_) => 0.0,
        }
    }

    /// The angle of a variable at the start, if it is a direction.
    pub(super) fn angle_of(&self, variable: Variable) -> Option<f64> {
        match variable {
            Variable::Input(_) => None,
            Variable::Angle(angle) => Some(self.cutter.at_start[angle.index()]),
            Variable::Found(number, index) => match self.solution(number, index)? {
                Solution::Slide(_) => None,
                solution @ Solution::Direction(_) => Some(self.angle_at_start(&solution)),
            },
        }
    }

    pub(super) fn solution(&self, number: usize, index: usize) -> Option<Solution<Value>> {
        self.cutter.solution(number, index)
    }

    /// The ranges of the inputs of a cone that goes back to them, so that everything that turns has turned as a whole; none if no
    /// number of turns is enough.
    pub(super) fn of_inputs(
        &self,
        variables: &[Variable],
        outputs: &[Value],
        cuts: &Cuts<'_>,
    ) -> Vec<Interval> {
        let read = self.read(outputs, cuts);
        let range = |variable: &Variable| match *variable {
            Variable::Input(input) if self.turns(input) => {
                let range = self.of_input(input);
                let start = self.start(input);
                match self.period(input, &read) {
                    Some(period) if range.width() > period => {
                        Interval::new(start - 0.5 * period, start + 0.5 * period)
                    }
                    _ => range,
                }
            }
            variable => self.of_variable(variable),
        };
        variables.iter().map(range).collect()
    }

    /// Returns the turn of a motor after which all angles that are read of it have made whole turns; none if its value itself is read.
    pub(crate) fn period(&self, input: usize, read: &InputReads) -> Option<f64> {
        if read.inputs.contains(&input) {
            return None;
        }
        let mut exact = Vec::new();
        for &place in &read.staircases {
            if let Some(&part) = self.cutter.parts(place)?.get(&input) {
                exact.push(steps_of_turns(part * TAU)?);
            }
        }
        for &angle in &read.angles {
            if let Some(&part) = self.cutter.parts(angle)?.get(&input) {
                exact.push(self.cutter.turns_until_whole(angle, input, part)?);
            }
        }
        let whole = exact.iter().try_fold(1_i64, |whole, (_, d)| {
            let times = d / num_integer::gcd(whole, *d).max(1);
            let all = whole.checked_mul(times);
            all.filter(|all| (1..=MOST_TURNS).contains(all))
        })?;
        // Each turns so often while the motor makes so many turns; all of them have turned as a whole when the slowest has.
        let mut often = exact.iter().map(|(n, d)| n.checked_mul(whole / d));
        let often = often.try_fold(0, |often, own| Some(num_integer::gcd::<i64>(often, own?)))?;
        let often = often.max(1);
        #[expect(clippy::cast_precision_loss, reason = "small whole numbers")]
        Some((TAU * whole as f64 / often as f64).next_up())
    }

    /// Finds the reads of the inputs by these outputs.
    pub(crate) fn read(&self, outputs: &[Value], cuts: &Cuts<'_>) -> InputReads {
        let mut read = InputReads::default();
        let mut seen: BTreeSet<Value> = BTreeSet::new();
        let mut cut: BTreeSet<Value> = BTreeSet::new();
        let mut waiting: Vec<Value> = outputs.to_vec();
        while let Some(value) = waiting.pop() {
            if !seen.insert(value) {
                continue;
            }
            if self.cutter.is_cut(value, outputs, cuts) {
                cut.insert(value);
                continue;
            }
            match self.cutter.program.node(value).op {
                Op::Sin(angle) | Op::Cos(angle) if self.cutter.parts(angle).is_some() => {
                    read.angles.insert(angle);
                }
                Op::Stairs(stairs, place, _)
                    if stairs.repeats && self.cutter.parts(place).is_some() =>
                {
                    read.staircases.insert(place);
                }
                Op::Input(input) => {
                    read.inputs.insert(input.index());
                }
                op => waiting.extend(op.operands()),
            }
        }
        let places = read.staircases.iter();
        let stepped = places.filter_map(|place| self.cutter.parts(*place));
        let stepped: BTreeSet<usize> = stepped.flat_map(BTreeMap::into_keys).collect();
        // What goes up by a step in each turn is never back.
        let climbs = |input: &usize| !self.is_level(outputs, &seen, &cut, *input);
        read.inputs.extend(stepped.into_iter().filter(climbs));
        read
    }

    /// Whether these outputs neither rise nor fall in the long run if an input grows, from the values that they read, as far as these
    /// were followed.
    fn is_level(
        &self,
        outputs: &[Value],
        seen: &BTreeSet<Value>,
        cut: &BTreeSet<Value>,
        input: usize,
    ) -> bool {
        let mut means: BTreeMap<Value, Option<f64>> = BTreeMap::new();
        for &value in seen {
            let of = |value: Value| means.get(&value).copied().unwrap_or(Some(0.0));
            let both = |a: Value, b: Value, sign: f64| {
                let (a, b) = (of(a)?, sign * of(b)?);
                let is_rounding = (a + b).abs() <= ROUNDING * a.abs();
                Some(if is_rounding { 0.0 } else { a + b })
            };
            let scaled = |a: Value, by: f64| Some(by * of(a)?);
            let constant = |value: Value| match self.cutter.program.node(value).op {
                Op::Constant(number) => Some(number.get()),
                _ => None,
            };
            let op = self.cutter.program.node(value).op;
            let mean = match op {
                _ if cut.contains(&value) => Some(0.0),
                Op::Stairs(stairs, place, _) if stairs.repeats => {
                    let part = self.cutter.parts(place).map(|parts| parts.get(&input).copied());
                    // Of the slope of a staircase nothing is left after a step.
                    part.map(|part| part.filter(|_| stairs.order == 0).unwrap_or(0.0))
                }
                Op::Sin(angle) | Op::Cos(angle) if self.cutter.parts(angle).is_some() => Some(0.0),
                Op::Input(own) => Some(if own.index() == input { 1.0 } else { 0.0 }),
                Op::Neg(a) => scaled(a, -1.0),
                Op::Add(a, b) => both(a, b, 1.0),
                Op::Sub(a, b) => both(a, b, -1.0),
                Op::Mul(a, b) => match (constant(a), constant(b)) {
                    (Some(by), _) => scaled(b, by),
                    (_, Some(by)) => scaled(a, by),
                    _ => [a, b].iter().all(|a| of(*a) == Some(0.0)).then_some(0.0),
                },
                Op::Div(a, by) if constant(by).is_some() => {
                    constant(by).and_then(|by| scaled(a, 1.0 / by))
                }
                op => op.operands().all(|a| of(a) == Some(0.0)).then_some(0.0),
            };
            means.insert(value, mean);
        }
        let mut outputs = outputs.iter();
        outputs.all(|output| means.get(output).copied().flatten() == Some(0.0))
    }
}

/// The reads of the inputs.
#[derive(Clone, Debug, Default)]
pub(crate) struct InputReads {
    /// Angles of which only sine and cosine are read.
    angles: BTreeSet<Value>,
    /// The places of staircases that are climbed for ever: sums of inputs.
    staircases: BTreeSet<Value>,
    /// Inputs that are read otherwise.
    inputs: BTreeSet<usize>,
}

/// Steps of a staircase in a number of turns, if so many in a turn make a whole number in a few.
fn steps_of_turns(in_a_turn: f64) -> Option<(i64, i64)> {
    let mut turns = 1..=MOST_PARTS;
    turns.find_map(|turns| {
        let steps = in_a_turn * f64::from(turns);
        let whole = steps.round();
        if (steps - whole).abs() >= ROUNDING * whole.abs() || whole.abs() > 1e9 {
            return None;
        }
        #[expect(clippy::cast_possible_truncation, reason = "a small whole number")]
        let whole = whole as i64;
        Some((whole, i64::from(turns)))
    })
}

/// All directions.
fn whole_turn() -> Interval {
    Interval::new(-PI.next_up(), PI.next_up())
}
