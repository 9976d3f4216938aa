//! Where an iteration starts: at the last position, or further on in the sense in which the mechanism moves.
//!
//! As long as the motors move by equal steps, each unknown is followed by its differences from step to step: a direction by the
//! rotation from one position to the next, by the rotation from that to the next such rotation, and so on. To go on in the same
//! way costs a few products, and each order brings the start nearer by a factor of the step. Where the motors change their step
//! the differences are forgotten.

use super::Writer;
use super::closing::First;
use crate::model::JointKind;
use crate::plan::{Algebra, Solution};
use crate::program::node::{Op, Value};
use std::f64::consts::TAU;

/// By what part of itself a motor's step may differ from the one before and still be the same.
const SAME: f64 = 1e-3;

/// The differences of an unknown, as they were left by the last position.
pub(super) struct History {
    last: Solution<Value>,
    /// For each order where it is kept, and its value.
    differences: Vec<(Kept, Solution<Value>)>,
}

/// Where a difference is kept.
#[derive(Clone, Copy)]
struct Kept(usize);

/// Whether the motors' steps are equal: not negative if so.
#[derive(Clone, Copy)]
pub(super) struct Steady {
    /// This step to the last.
    now: Value,
    /// And the last to the one before that too.
    before: Value,
}

impl Writer<'_> {
    /// Where the iteration of the present loop starts.
    pub(super) fn predicted(&mut self, firsts: Vec<First>) -> (Vec<First>, Vec<History>) {
        let order = self.choice().predictor;
        if order == 0 {
            return (firsts, Vec::new());
        }
        let steady = self.steady();
        let mut histories = Vec::new();
        let mut predicted = Vec::new();
        for (name, last) in firsts {
            let history = self.history(last, order);
            let guess = match self.go_on(&history) {
                // The iteration keeps lengths: what is too long here would be longer in every position that follows.
                Solution::Direction(guess) => Solution::Direction(self.normalised(guess, &name)),
                guess @ Solution::Slide(_) => guess,
            };
            let guess = self.choose(steady.now, guess, last);
            histories.push(history);
            predicted.push((name, guess));
        }
        (predicted, histories)
    }

    fn history(&mut self, last: Solution<Value>, order: u8) -> History {
        let differences = (0..order).map(|_| {
            let first = self.state.len();
            let state = match last {
                Solution::Direction(_) => Solution::Direction([self.keep(1.0), self.keep(0.0)]),
                Solution::Slide(_) => Solution::Slide(self.keep(0.0)),
            };
            (Kept(first), state)
        });
        History {
            last,
            differences: differences.collect(),
        }
    }

    /// The last value, moved on by all differences.
    fn go_on(&mut self, history: &History) -> Solution<Value> {
        let mut guess = history.last;
        for (_, difference) in &history.differences {
            guess = match (guess, *difference) {
                (Solution::Direction(guess), Solution::Direction(turn)) => {
                    Solution::Direction(self.builder.turned(guess, turn))
                }
                (Solution::Slide(guess), Solution::Slide(displacement)) => {
                    Solution::Slide(self.builder.add(guess, displacement))
                }
                (guess, _) => guess,
            };
        }
        guess
    }

    /// Keeps the new differences.
    pub(super) fn remember(&mut self, histories: &[History], solution: &[Solution<Value>]) {
        if histories.is_empty() {
            return;
        }
        let steady = self.steady();
        for (history, now) in histories.iter().zip(solution) {
            let mut new = self.difference(*now, history.last);
            for (order, (state, old)) in history.differences.iter().enumerate() {
                // The first difference always holds; the second needs two equal steps, all others three.
                let valid = match order {
                    0 => None,
                    1 => Some(steady.now),
                    _ => Some(steady.before),
                };
                let still = self.still(new);
                let held = match valid {
                    None => new,
                    Some(valid) => self.choose(valid, new, still),
                };
                self.put_kept(*state, held);
                new = self.difference(held, *old);
            }
        }
    }

    fn put_kept(&mut self, Kept(first): Kept, value: Solution<Value>) {
        match value {
            Solution::Direction([cos, sin]) => {
                self.state[first] = cos;
                self.state[first + 1] = sin;
            }
            Solution::Slide(displacement) => self.state[first] = displacement,
        }
    }

    /// From one value to another.
    fn difference(&mut self, to: Solution<Value>, from: Solution<Value>) -> Solution<Value> {
        match (to, from) {
            (Solution::Direction(to), Solution::Direction(from)) => {
                let back = self.builder.conjugate(from);
                Solution::Direction(self.builder.turned(back, to))
            }
            (Solution::Slide(to), Solution::Slide(from)) => {
                Solution::Slide(self.builder.sub(to, from))
            }
            (to, _) => to,
        }
    }

    /// No difference.
    fn still(&mut self, like: Solution<Value>) -> Solution<Value> {
        match like {
            Solution::Direction(_) => Solution::Direction(self.builder.vector([1.0, 0.0])),
            Solution::Slide(_) => Solution::Slide(self.builder.constant(0.0)),
        }
    }

    fn choose(&mut self, test: Value, a: Solution<Value>, b: Solution<Value>) -> Solution<Value> {
        let mut choose = |a, b| self.builder.make(Op::Choose(test, a, b));
        match (a, b) {
            (Solution::Direction([a, b]), Solution::Direction([c, d])) => {
                Solution::Direction([choose(a, c), choose(b, d)])
            }
            (Solution::Slide(a), Solution::Slide(b)) => Solution::Slide(choose(a, b)),
            (a, _) => a,
        }
    }

    /// Whether the motors move by equal steps, found once for all loops.
    fn steady(&mut self) -> Steady {
        if let Some(steady) = self.steady {
            return steady;
        }
        let mut now: Option<Value> = None;
        for input in 0..self.model.inputs() {
            let motor = self.model.motors.get(input);
            let turns = motor.is_some_and(|motor| {
                matches!(self.model.joint(motor.joint).kind, JointKind::Revolute(..))
            });
            let value = self.builder.make(Op::Motor(input));
            let before = self.keep(self.builder.at_start(value));
            self.put_last(value);
            let mut step = self.builder.sub(value, before);
            if turns {
                let turns = self.builder.make(Op::Turns(input));
                let before = self.keep(0.0);
                self.put_last(turns);
                let turns = self.builder.sub(turns, before);
                let turn = self.builder.constant(TAU);
                let turned = self.builder.mul(turn, turns);
                step = self.builder.add(step, turned);
            }
            let last = self.keep(0.0);
            self.put_last(step);
            let (size, change) = (self.builder.abs(last), self.builder.sub(step, last));
            let (same, change) = (self.builder.constant(SAME), self.builder.abs(change));
            let allowed = self.builder.mul(same, size);
            let test = self.builder.sub(allowed, change);
            now = Some(match now {
                None => test,
                Some(now) => self.builder.make(Op::Choose(now, test, now)),
            });
        }
        // Without an input nothing is ever steady.
        let never = self.builder.constant(-1.0);
        let now = self.builder.name(now.unwrap_or(never), "steady");
        let last = self.keep(-1.0);
        self.put_last(now);
        let before = self.builder.make(Op::Choose(now, last, now));
        *self.steady.insert(Steady { now, before })
    }

    /// What was kept last is this from now on.
    fn put_last(&mut self, value: Value) {
        if let Some(last) = self.state.last_mut() {
            *last = value;
        }
    }
}
