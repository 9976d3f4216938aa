//! Where an iteration starts: at the last position, or further on in the sense in which the mechanism moves.
//!
//! As long as the motors move by equal steps, each unknown is followed by its differences from step to step: a direction by the
//! rotation from one position to the next, by the rotation from that to the next such rotation, and so on. To go on in the same
//! way costs a few products, and each order brings the start nearer by a factor of the step. Where the motors change their step
//! the differences are forgotten.

use super::last::LastUnknown;
use crate::model::{InputId, Model};
use crate::plan::{Algebra, Arithmetic, Solution};
use crate::program::builder::SsaBuilder;
use crate::program::node::{Op, Value};
use std::f64::consts::TAU;

/// By what part of itself a motor's step may differ from the one before and still be the same.
const SAME: f64 = 1e-3;

/// Predicts the unknowns of iterations.
pub(super) struct Predictor {
    /// For each motor and param whether it turns.
    inputs: Vec<bool>,
    /// Whether the inputs' steps are equal, once something asked.
    steady: Option<Steady>,
}

/// The differences of an unknown, as they were left by the last position.
pub(super) struct History {
    last: Solution<Value>,
    /// For each order its first index in the state, and its value.
    differences: Vec<(usize, Solution<Value>)>,
}

/// Whether the motors' steps are equal: not negative if so.
#[derive(Clone, Copy)]
struct Steady {
    /// This step to the last.
    now: Value,
    /// And the last to the one before that too.
    before: Value,
}

impl Predictor {
    pub(super) fn new(model: &Model) -> Self {
        let turns = model.motors.iter().map(|motor| model.turns(motor.joint));
        Self { inputs: turns.chain(model.params.ids().map(|_| false)).collect(), steady: None }
    }

    /// Predicts each unknown from so many of its differences, and gives its history; from none, it stays where it was.
    pub(super) fn predict(
        &mut self,
        ssa: &mut SsaBuilder,
        order: u8,
        unknowns: &mut [LastUnknown],
    ) -> Vec<History> {
        if order == 0 {
            return Vec::new();
        }
        let steady = self.steady(ssa);
        let mut histories = Vec::new();
        for LastUnknown { name, value } in unknowns {
            let history = History::new(ssa, *value, order);
            let guess = match history.extrapolate(ssa) {
                // The iteration keeps lengths: what is too long here would be longer in every position that follows.
                Solution::Direction(guess) => Solution::Direction(ssa.normalise(guess, name)),
                guess @ Solution::Slide(_) => guess,
            };
            *value = ssa.choose(steady.now, guess, *value);
            histories.push(history);
        }
        histories
    }

    /// Updates the differences of unknowns that are solved.
    pub(super) fn remember(
        &mut self,
        ssa: &mut SsaBuilder,
        histories: &[History],
        solution: &[Solution<Value>],
    ) {
        if histories.is_empty() {
            return;
        }
        let steady = self.steady(ssa);
        for (history, now) in histories.iter().zip(solution) {
            let mut new = difference(ssa, *now, history.last);
            for (order, (first, old)) in history.differences.iter().enumerate() {
                // The first difference always holds; the second needs two equal steps, all others three.
                let valid = match order {
                    0 => None,
                    1 => Some(steady.now),
                    _ => Some(steady.before),
                };
                let none = no_difference(ssa, new);
                let held = match valid {
                    None => new,
                    Some(valid) => ssa.choose(valid, new, none),
                };
                for (index, number) in (*first..).zip(held.numbers()) {
                    ssa.update(index, number);
                }
                new = difference(ssa, held, *old);
            }
        }
    }

    /// Whether the motors move by equal steps, found once for all loops.
    fn steady(&mut self, ssa: &mut SsaBuilder) -> Steady {
        if let Some(steady) = self.steady {
            return steady;
        }
        let mut now: Option<Value> = None;
        for (input, &turns) in self.inputs.iter().enumerate() {
            let value = ssa.make(Op::Input(InputId::new(input)));
            let before = ssa.record(value).last;
            let mut step = ssa.sub(value, before);
            if turns {
                let turns = ssa.make(Op::Turns(InputId::new(input)));
                let before = ssa.record(turns).last;
                let turns = ssa.sub(turns, before);
                let turn = ssa.constant(TAU);
                let turned = ssa.mul(turn, turns);
                step = ssa.add(step, turned);
            }
            let last = ssa.carry(0.0);
            ssa.update(last.index, step);
            let last = last.last;
            let (size, change) = (ssa.abs(last), ssa.sub(step, last));
            let (same, change) = (ssa.constant(SAME), ssa.abs(change));
            let allowed = ssa.mul(same, size);
            let test = ssa.sub(allowed, change);
            now = Some(match now {
                None => test,
                Some(now) => ssa.make(Op::Choose(now, test, now)),
            });
        }
        // Without an input nothing is ever steady.
        let never = ssa.constant(-1.0);
        let now = ssa.name(now.unwrap_or(never), "steady");
        let last = ssa.carry(-1.0);
        ssa.update(last.index, now);
        let before = ssa.make(Op::Choose(now, last.last, now));
        *self.steady.insert(Steady { now, before })
    }
}

impl History {
    fn new(ssa: &mut SsaBuilder, last: Solution<Value>, order: u8) -> Self {
        let differences = (0..order).map(|_| match last {
            Solution::Direction(_) => {
                let (cos, sin) = (ssa.carry(1.0), ssa.carry(0.0));
                (cos.index, Solution::Direction([cos.last, sin.last]))
            }
            Solution::Slide(_) => {
                let displacement = ssa.carry(0.0);
                (displacement.index, Solution::Slide(displacement.last))
            }
        });
        Self { last, differences: differences.collect() }
    }

    /// The last value, moved on by all differences.
    fn extrapolate(&self, ssa: &mut SsaBuilder) -> Solution<Value> {
        let differences = self.differences.iter();
        differences.fold(self.last, |guess, (_, difference)| match (guess, *difference) {
            (Solution::Direction(guess), Solution::Direction(turn)) => {
                Solution::Direction(ssa.rotate(guess, turn))
            }
            (Solution::Slide(guess), Solution::Slide(displacement)) => {
                Solution::Slide(ssa.add(guess, displacement))
            }
            (guess, _) => guess,
        })
    }
}

/// From one value to another.
fn difference(ssa: &mut SsaBuilder, to: Solution<Value>, from: Solution<Value>) -> Solution<Value> {
    match (to, from) {
        (Solution::Direction(to), Solution::Direction(from)) => {
            let back = ssa.conjugate(from);
            Solution::Direction(ssa.rotate(back, to))
        }
        (Solution::Slide(to), Solution::Slide(from)) => Solution::Slide(ssa.sub(to, from)),
        (to, _) => to,
    }
}

/// The difference of equal values of this kind.
fn no_difference(ssa: &mut SsaBuilder, like: Solution<Value>) -> Solution<Value> {
    match like {
        Solution::Direction(_) => Solution::Direction(ssa.vector([1.0, 0.0])),
        Solution::Slide(_) => Solution::Slide(ssa.constant(0.0)),
    }
}
