//! Loops that are carried: what turns a loop as a whole has no part in whether it closes.

use super::Interval;
use super::claim::HeldValues;
use super::cone::{Cone, Cuts, Cutter, Variable};
use super::tape::Tape;
use crate::cancel;
use crate::plan::Solution;
use crate::program::{ClosedForm, Op, Program, Value};
use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

/// At so many places a loop is turned by each of these angles, to see whether its numbers notice it.
const PLACES: usize = 4;
const TURNS: [f64; 3] = [1.0, 2.3, 4.1];
/// An interval that is no wider than this, relative to its numbers, is as narrow as rounding lets it be.
const TIGHT: f64 = 1e-9;
/// Places are spread by multiples of this.
const SPREAD: f64 = 0.618_033_988_749_894_9;

/// The directions in which a loop is carried, at the start: if they have no part in its slack, it closes in one as in all others. What
/// has a part must not be made from them.
pub(super) fn find_held(cutter: &Cutter<'_>, closed: &ClosedForm) -> HeldValues {
    let outputs = [closed.discriminant, closed.tolerance];
    let Some(cone) = cutter.cone(&outputs, &Cuts::ALONE) else {
        return HeldValues::new();
    };
    let mut trial = Trial::new(&cone, &cone.outputs, &[]);
    let variables = cone.variables.iter().enumerate();
    let (mut with_part, mut without): (Vec<Vec<Value>>, Vec<Vec<Value>>) = (Vec::new(), Vec::new());
    for (index, variable) in variables {
        let values = directions(cutter, *variable);
        let mut has_part = || {
            let trial = trial.as_mut();
            trial.is_none_or(|trial| trial.turned_along(index).is_none())
        };
        if values.is_empty() || has_part() {
            with_part.push(values_of(cutter, *variable));
        } else {
            without.push(values);
        }
    }
    while let Some(values) = with_part.pop() {
        let made_from = made_from(cutter.program, values, &HeldValues::new());
        let (used, unused) = without
            .into_iter()
            .partition(|values| values.iter().any(|value| made_from.contains(value)));
        without = unused;
        with_part.extend::<Vec<Vec<Value>>>(used);
    }
    let at_start = |value: Value| (value, cutter.at_start[value.index()]);
    without.into_iter().flatten().map(at_start).collect()
}

/// The values that a variable stands for: none for what is given from outside.
fn values_of(cutter: &Cutter<'_>, variable: Variable) -> Vec<Value> {
    match variable {
        Variable::Found(number, index) => match cutter.solution(number, index) {
            Some(Solution::Slide(displacement)) => vec![displacement],
            _ => directions(cutter, variable),
        },
        _ => directions(cutter, variable),
    }
}

/// All values that these values are computed from, themselves included. What is held counts as a constant and leads no farther.
pub(super) fn made_from(
    program: &Program,
    values: Vec<Value>,
    held: &HeldValues,
) -> BTreeSet<Value> {
    cancel::check();
    let mut made_from = BTreeSet::new();
    let mut waiting = values;
    while let Some(value) = waiting.pop() {
        let is_held = held.iter().any(|(other, _)| *other == value);
        if !is_held && made_from.insert(value) {
            waiting.extend(program.node(value).op.operands());
        }
    }
    made_from
}

/// The cosine and the sine of a variable that turns, as the program has them; nothing for one that slides.
fn directions(cutter: &Cutter<'_>, variable: Variable) -> Vec<Value> {
    let program = cutter.program;
    match variable {
        Variable::Input(_) => Vec::new(),
        Variable::Angle(angle) => {
            let nodes = program.ssa.nodes.iter().enumerate();
            let of = nodes.filter(
                |(_, node)| matches!(node.op, Op::Sin(other) | Op::Cos(other) if other == angle),
            );
            of.map(|(index, _)| Value::at(index)).collect()
        }
        Variable::Found(number, index) => match cutter.solution(number, index) {
            Some(Solution::Direction(direction)) => direction.to_vec(),
            _ => Vec::new(),
        },
    }
}

/// A cone at some places, where it is turned by each of its variables.
pub(crate) struct Trial<'c> {
    tape: Tape<'c>,
    numbers: usize,
    /// The numbers, then the coordinates of the vectors.
    outputs: Vec<Value>,
    /// Each place, and what the outputs are there.
    places: Vec<(Vec<f64>, Vec<Interval>)>,
}

impl<'c> Trial<'c> {
    /// Looks at numbers and vectors of a cone; none if it is too large.
    pub(crate) fn new(cone: &'c Cone, numbers: &[Value], vectors: &[[Value; 2]]) -> Option<Self> {
        let vectors = vectors.iter().flatten();
        let outputs: Vec<Value> = numbers.iter().chain(vectors).copied().collect();
        let tape = Tape::of(&cone.nodes, cone.variables.len(), Vec::new(), &outputs);
        let mut trial = Self {
            numbers: numbers.len(),
            places: Vec::new(),
            tape: (!tape.is_too_large()).then_some(tape)?,
            outputs,
        };
        for number in 0..PLACES {
            let place = place(cone, number);
            let values = trial.values(&place);
            trial.places.push((place, values));
        }
        Some(trial)
    }

    fn values(&mut self, place: &[f64]) -> Vec<Interval> {
        self.tape.run_at(place);
        let value = |value: &Value| self.tape.value(*value);
        self.outputs.iter().map(value).collect()
    }

    /// Which vectors turn along with a variable, if it has no other part in them and none in the numbers. What is the same has enclosures
    /// that overlap wherever it is computed; what is not differs by more than rounding at some place. A wide enclosure tells nothing.
    pub(crate) fn turned_along(&mut self, variable: usize) -> Option<Vec<bool>> {
        cancel::check();
        let vectors = (self.outputs.len() - self.numbers) / 2;
        let (mut stays, mut turns) = (vec![true; vectors], vec![true; vectors]);
        for number in 0..PLACES {
            let (mut place, before) = self.places[number].clone();
            let from = place[variable];
            for turn in TURNS {
                place[variable] += turn;
                let after = self.values(&place);
                let whole = place[variable] - from;
                let (cos, sin) = (Interval::point(whole).cos(), Interval::point(whole).sin());
                let same = |index: usize| is_same(before[index], after[index]);
                if !(0..self.numbers).all(same) {
                    return None;
                }
                for vector in 0..vectors {
                    let [x, y] = [0, 1].map(|part| self.numbers + 2 * vector + part);
                    let [u, v] =
                        [cos * before[x] - sin * before[y], sin * before[x] + cos * before[y]];
                    stays[vector] &= same(x) && same(y);
                    turns[vector] &= is_same(u, after[x]) && is_same(v, after[y]);
                }
            }
        }
        let all = stays.iter().zip(&turns).all(|(stays, turns)| *stays || *turns);
        // A vector that both stays and turns is zero: it counts as one that stays.
        all.then(|| stays.into_iter().map(|stays| !stays).collect())
    }
}

/// Tests whether two enclosures may be of the same number, and are as narrow as rounding lets them be.
pub(crate) fn is_same(a: Interval, b: Interval) -> bool {
    a.low() <= b.high() && b.low() <= a.high() && is_tight(a) && is_tight(b)
}

/// Whether an enclosure is as wide as rounding makes it.
fn is_tight(range: Interval) -> bool {
    range.width() <= TIGHT * (1.0 + range.abs().high())
}

/// Some place, the coordinates far from each other.
#[expect(clippy::cast_precision_loss, reason = "a few hundred")]
fn place(cone: &Cone, number: usize) -> Vec<f64> {
    let at = |index: usize| {
        let part = (SPREAD * (1 + index + number * cone.variables.len()) as f64).fract();
        TAU * part - PI
    };
    (0..cone.variables.len()).map(at).collect()
}
