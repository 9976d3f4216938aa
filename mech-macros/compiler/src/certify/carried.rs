//! Loops that are carried: what turns a loop as a whole has no part in whether it closes.

use super::Interval;
use super::cone::{Cone, Cuts, Cutter, Variable};
use super::tape::Tape;
use crate::plan::Solution;
use crate::program::{Closed, Op, Value};
use std::f64::consts::{PI, TAU};

/// At so many places it is looked whether a loop notices that it is turned, each time so far.
const PLACES: usize = 12;
const TURNS: [f64; 3] = [1.0, 2.3, 4.1];
/// Places are spread by multiples of this.
const SPREAD: f64 = 0.618_033_988_749_894_9;

/// Values that are held where they are at the start.
pub(super) type Held = Vec<(Value, f64)>;

/// The directions in which a loop is carried, at the start: if they have no part in its slack, it closes in one as in all others.
pub(super) fn held(cutter: &Cutter<'_>, closed: &Closed) -> Held {
    let cone = cutter.cone(&[closed.slack, closed.floor], &Cuts::ALONE);
    let mut held = Held::new();
    for (index, variable) in cone.variables.iter().enumerate() {
        let values = directions(cutter, *variable);
        if !values.is_empty() && !has_part(&cone, index) {
            let at_start = |value: Value| (value, cutter.at_start[value.index()]);
            held.extend(values.into_iter().map(at_start));
        }
    }
    held
}

/// Cosine and sine of what turns, as the program has them; of what slides nothing.
fn directions(cutter: &Cutter<'_>, variable: Variable) -> Vec<Value> {
    let program = cutter.program;
    match variable {
        Variable::Input(_) => Vec::new(),
        Variable::Angle(angle) => {
            let nodes = program.nodes.iter().enumerate();
            let of = nodes.filter(
                |(_, node)| matches!(node.op, Op::Sin(other) | Op::Cos(other) if other == angle),
            );
            of.map(|(index, _)| Value::at(index)).collect()
        }
        Variable::Found(number, index) => {
            let all = &program.solutions;
            let found = all.iter().find(|(of, _)| *of == number);
            match found.and_then(|(_, solutions)| solutions.get(index)) {
                Some(Solution::Direction(direction)) => direction.to_vec(),
                _ => Vec::new(),
            }
        }
    }
}

/// Whether a variable has a part in the outputs of a cone. What is the same has enclosures that overlap wherever it is computed; what is
/// not differs by more than rounding at some place.
fn has_part(cone: &Cone, variable: usize) -> bool {
    let mut tape = Tape::of(&cone.nodes, cone.variables.len(), Vec::new(), &cone.outputs);
    if tape.is_too_large() {
        return true;
    }
    let mut outputs = |place: &[f64]| -> Vec<Interval> {
        let place: Vec<Interval> = place.iter().copied().map(Interval::point).collect();
        tape.run(&place);
        cone.outputs
            .iter()
            .map(|value| tape.value(*value))
            .collect()
    };
    (0..PLACES).any(|number| {
        let mut place = place(cone, number);
        let before = outputs(&place);
        TURNS.iter().any(|turn| {
            place[variable] += turn;
            let after = outputs(&place);
            let mut both = before.iter().zip(&after);
            both.any(|(a, b)| a.high() < b.low() || b.high() < a.low())
        })
    })
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
