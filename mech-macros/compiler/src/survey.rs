//! Where the dyads of a mechanism come to their dead points and change points, found by moving it: only loops that have any
//! are watched when it moves, and only those that pass change points carry on which side they lie.
//!
//! Each motor is moved alone through its range, or through whole turns; the square of the sine of every transmission angle is
//! sampled on the way, and where it comes near zero its least value is looked for.

use crate::evaluate::{Machine, Stop};
use crate::model::{AtChangePoints, Model};
use crate::plan::Plan;
use crate::program::{AtZero, Choice, Position, Program, Solver, Watching, build_as};
use crate::walk::{Stretch, at, walk, walk_params};

/// How many operations a survey may cost.
const BUDGET: usize = 1_200_000;
/// How fast the square of a sine changes with a param, over its scale, where that could not be seen.
const UNSEEN: f64 = 4.0;
/// Samples in a turn.
const SAMPLES: [usize; 2] = [24, 360];
/// Where several motors move a loop, most of its positions were never seen.
const WIDE_SAFETY: f64 = 6.0;
/// Between samples a rate may be greater than any that was sampled.
const SAFETY: f64 = 1.5;
/// By this part of itself a bracket is cut.
const GOLDEN: f64 = 0.381_966_011_250_105_1;
/// Below this square of the distance of pins, as a part of the product of lengths, rounding stretches links.
const NEAR_PINS: f64 = 0.1;
/// Squares of sines above this are far from zero.
const NEAR: f64 = 0.1;

/// Whether a param has a part in a loop: then it may have dead points and change points that it has not at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Varying {
    /// None has.
    Never,
    /// One has, but there is only one way in which the loop can close.
    OneSided,
    /// One has, and there are two sides on which its dyad may lie.
    TwoSided,
}

/// What was found about a loop in closed form.
#[derive(Clone, Debug)]
struct Found {
    /// By how much the square of its sine changes with each motor and param.
    rates: Vec<f64>,
    /// Whether a param has a part in it.
    varying: Varying,
    /// Whether it fails to close somewhere.
    ends: bool,
    /// Whether it comes to zero and closes on both sides.
    crosses: bool,
    /// The least square of the distance of the pins that it joins, as a part of the product of its links' lengths.
    least_distance_square: f64,
}

/// Decides for every loop how it is watched; how it is solved is decided already.
pub(crate) fn survey(model: &Model, plan: &Plan, choices: Vec<Choice>) -> Vec<Choice> {
    let none = Found {
        rates: vec![0.0; model.inputs()],
        varying: Varying::Never,
        ends: false,
        crosses: false,
        least_distance_square: f64::INFINITY,
    };
    let mut found = vec![none; choices.len()];
    // A loop that goes over at a change point moves on otherwise, and so do those that need it: they are looked at again.
    for _ in 0..4 {
        let program = build_as(model, plan, &watched(model, &choices, &found));
        if program.watches.is_empty() {
            return choices;
        }
        for number in program.dependent_loops() {
            let sided = program
                .all_closed()
                .any(|(_, closed)| closed.number == number && closed.sided);
            found[number].varying = if sided {
                Varying::TwoSided
            } else {
                Varying::OneSided
            };
        }
        let crossings = |found: &[Found]| found.iter().filter(|found| found.crosses).count();
        let before = crossings(&found);
        let mut walker = Walker {
            program: &program,
            found: &mut found,
        };
        walk(model, plan, |stretch| walker.straight(stretch));
        if !model.params.is_empty() {
            walk_params(model, &mut |stretch| walker.straight(stretch));
        }
        if crossings(&found) == before {
            break;
        }
    }
    decided(model, choices, &found)
}

/// Every loop watched, but only those known to pass change points for more than their sine.
fn watched(model: &Model, choices: &[Choice], found: &[Found]) -> Vec<Choice> {
    let watched = choices.iter().zip(found).map(|(choice, found)| Choice {
        watching: Some(if found.crosses {
            Watching {
                rates: found.rates.iter().map(|rate| SAFETY * rate).collect(),
                at_zero: AtZero::GoOver,
            }
        } else {
            Watching {
                rates: vec![0.0; model.inputs()],
                at_zero: AtZero::Stay,
            }
        }),
        solver: Solver::ClosedForm,
        predictor: 0,
        side: choice.side,
        proved: false,
        pins_near: false,
    });
    watched.collect()
}

/// What follows for each loop.
fn decided(model: &Model, choices: Vec<Choice>, found: &[Found]) -> Vec<Choice> {
    let unseen: Vec<f64> = unseen_rates(model);
    let decide = |(choice, found): (Choice, &Found)| {
        let varies = found.varying != Varying::Never;
        // With other params it may pass change points, whatever it does now.
        let at_zero = match (
            found.crosses || found.varying == Varying::TwoSided,
            model.change_points,
        ) {
            (true, AtChangePoints::GoOn) => Some(AtZero::GoOver),
            (true, AtChangePoints::Stop) => Some(AtZero::Stop),
            (true, AtChangePoints::KeepBranch) | (false, _) => {
                let movers = found.rates.iter().filter(|rate| **rate > 0.0).count();
                (found.ends || varies || movers > 1).then_some(AtZero::Stay)
            }
        };
        // An iteration fails where its equations are singular: a loop that comes to dead points or change points is solved in
        // closed form whatever was wished.
        let solver = if found.crosses || found.ends || varies {
            Solver::ClosedForm
        } else {
            choice.solver
        };
        let movers = found.rates.iter().filter(|rate| **rate > 0.0).count();
        let safety = if movers > 1 || varies {
            WIDE_SAFETY
        } else {
            SAFETY
        };
        let rates = found.rates.iter().zip(&unseen).map(|(rate, unseen)| {
            let least = if varies { *unseen } else { 0.0 };
            (safety * rate).max(least)
        });
        let watching = at_zero.map(|at_zero| Watching {
            rates: rates.collect(),
            at_zero,
        });
        Choice {
            solver,
            predictor: choice.predictor,
            watching,
            side: choice.side,
            proved: false,
            pins_near: found.least_distance_square < NEAR_PINS,
        }
    };
    choices.into_iter().zip(found).map(decide).collect()
}

/// How fast the square of a sine is taken to change with each motor and param, if a loop varies with params, at least.
fn unseen_rates(model: &Model) -> Vec<f64> {
    let motors = model.motors.iter().map(|_| 0.0);
    let params = model.params.ids().map(|param| {
        let scale = model.param_scale(param);
        scale.map_or(0.0, |scale| UNSEEN / scale)
    });
    motors.chain(params).collect()
}

/// A walk through the motions of a program.
struct Walker<'a> {
    program: &'a Program,
    found: &'a mut [Found],
}

impl Walker<'_> {
    /// Moves the motors straight from the start; tells whether it came to the end.
    fn straight(&mut self, stretch: &Stretch) -> bool {
        let Stretch { ways, pieces } = stretch;
        let live = self.program.live.iter().filter(|live| **live).count();
        let affordable = BUDGET / (live * pieces * ways.len()).max(1);
        let samples = pieces * affordable.clamp(SAMPLES[0], SAMPLES[1]);
        let mut machine = Machine::<f64>::new(self.program);
        let mut trail = vec![(0.0, machine.position().clone())];
        for sample in 1..=samples {
            #[expect(clippy::cast_precision_loss, reason = "a few thousand samples")]
            let part = sample as f64 / samples as f64;
            match machine.move_to(&at(&self.program.start.motors, ways, part)) {
                Ok(()) => trail.push((part, machine.position().clone())),
                Err(stop) => {
                    self.ends(stop);
                    self.look(&trail, ways);
                    self.unseen(ways);
                    return false;
                }
            }
        }
        self.look(&trail, ways);
        true
    }

    fn ends(&mut self, stop: Stop) {
        let block = match stop {
            Stop::Open(block) | Stop::DeadPoint(block) | Stop::ChangePoint(block) => Some(block),
            _ => None,
        };
        match block.and_then(|block| self.program.closed(block)) {
            Some(closed) => self.found[closed.number].ends = true,
            // Whatever it was, nobody knows what is beyond.
            None => self.found.iter_mut().for_each(|found| found.ends = true),
        }
    }

    /// Where these motors cannot go farther, they may if others are elsewhere: nobody saw what their loops do there.
    fn unseen(&mut self, ways: &[f64]) {
        if ways.len() < 2 {
            return;
        }
        for found in self.found.iter_mut() {
            let mut moved = found.rates.iter().zip(ways);
            found.ends |= moved.any(|(rate, way)| *rate > 0.0 && *way != 0.0);
        }
    }

    /// Looks at what was sampled.
    fn look(&mut self, trail: &[(f64, Position<f64>)], ways: &[f64]) {
        for watch in &self.program.watches {
            let Some(closed) = self.program.closed(watch.block) else {
                continue;
            };
            let squares: Vec<f64> = trail
                .iter()
                .map(|(_, position)| position.kept[watch.kept].powi(2))
                .collect();
            let found = &mut self.found[closed.number];
            // Rounding hides the side the more, the farther the pins are from each other.
            let rounding = 16.0 * self.program.precision.epsilon();
            found.least_distance_square = trail
                .iter()
                .map(|(_, position)| position.kept[watch.kept + 1] / rounding)
                .fold(found.least_distance_square, f64::min);
            let steepest = squares
                .windows(2)
                .zip(trail.windows(2))
                .map(|(squares, ends)| (squares[1] - squares[0]).abs() / (ends[1].0 - ends[0].0))
                .fold(0.0, f64::max);
            self.steep(closed.number, steepest, ways);
            if self.found[closed.number].crosses {
                continue;
            }
            let crosses = (1..squares.len().saturating_sub(1)).any(|at| {
                let least = squares[at] <= squares[at - 1] && squares[at] <= squares[at + 1];
                least
                    && squares[at] < NEAR
                    && self.touches(watch.kept, &trail[at - 1], trail[at + 1].0, ways)
            });
            self.found[closed.number].crosses = crosses;
        }
    }

    /// The rates must explain what was seen.
    fn steep(&mut self, number: usize, steepest: f64, ways: &[f64]) {
        let rates = &mut self.found[number].rates;
        let moved: Vec<usize> = (0..ways.len())
            .filter(|&motor| ways[motor] != 0.0)
            .collect();
        if let [motor] = moved[..] {
            rates[motor] = rates[motor].max(steepest / ways[motor].abs());
            return;
        }
        let explained: f64 = rates
            .iter()
            .zip(ways)
            .map(|(rate, way)| rate * way.abs())
            .sum();
        if explained > 0.0 && steepest > explained {
            for rate in rates {
                *rate *= steepest / explained;
            }
        }
    }

    /// Whether the square of a sine comes to zero between two samples: its least value is looked for by thirds.
    fn touches(
        &self,
        kept: usize,
        (from, position): &(f64, Position<f64>),
        to: f64,
        ways: &[f64],
    ) -> bool {
        let mut machine = Machine::<f64>::new(self.program);
        let mut square = |part: f64| {
            machine.put_back(position.clone());
            let moved = machine.move_to(&at(&self.program.start.motors, ways, part));
            let kept = &machine.position().kept[kept..];
            moved.is_ok().then(|| (kept[0].powi(2), kept[1]))
        };
        let (mut low, mut high) = (*from, to);
        let mut at = [low + GOLDEN * (high - low), high - GOLDEN * (high - low)];
        let (Some(first), Some(second)) = (square(at[0]), square(at[1])) else {
            return false;
        };
        let mut values = [first, second];
        for _ in 0..64 {
            if values.iter().any(|(square, tiny)| square <= tiny) {
                return true;
            }
            let next = if values[0].0 < values[1].0 {
                high = at[1];
                (at[1], values[1]) = (at[0], values[0]);
                at[0] = low + GOLDEN * (high - low);
                0
            } else {
                low = at[0];
                (at[0], values[0]) = (at[1], values[1]);
                at[1] = high - GOLDEN * (high - low);
                1
            };
            match square(at[next]) {
                Some(value) => values[next] = value,
                None => return false,
            }
        }
        false
    }
}
