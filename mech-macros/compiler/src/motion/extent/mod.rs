//! How much room a mechanism takes, found by moving it: each motor alone, all together, and from the outermost positions on outwards.

mod seen;

use crate::evaluate::Machine;
use crate::model::{JointKind, Model, Motor};
use crate::motion::sweep::{MostTurns, Sweep, interpolate, sweep_motors};
use crate::plan::{Halton, Plan};
use crate::program::{Position, Program};
pub(crate) use seen::Reach;
use seen::{EMPTY, SIDES, SeenPoints, Sides};
use std::f64::consts::TAU;

/// How many operations a sweep, the positions of all motors together, and the way outwards may cost, each.
const BUDGET: usize = 150_000;
/// Turns of a motor: a wheel behind a worm has turned as a whole after so many.
const MOST_TURNS: i64 = 1 << 16;
/// Where a move goes in pieces, each turn on the way costs some: operations that all turns of a sweep may cost.
const BUDGET_OF_PIECES: usize = 4_000_000;
/// About as many pieces take a turn of the fastest link.
const PIECES: usize = 4;
/// Samples in a turn of the fastest link.
const SAMPLES: [usize; 2] = [24, 120];
/// Positions of all motors together.
const TOGETHER: [usize; 2] = [16, 512];
/// Rounds on the way outwards, each with steps half as long: the last are a millionth of a turn.
const ROUNDS: usize = 16;
/// The first of these steps, as a part of a motor's turn or range.
const FIRST_STEP: f64 = 1.0 / 48.0;

/// The upright box around all that was seen wherever the mechanism was moved to: lower left and upper right corner. What is seen are
/// the shapes of each link, or joints and named points if there is no shape; if there is nothing, the box is the origin.
pub(crate) fn extent(
    model: &Model,
    plan: &Plan,
    program: &Program,
    shapes: &[Vec<Reach>],
) -> [[f64; 2]; 2] {
    let mut survey = Survey::new(model, program, shapes);
    let most_turns = survey.most_turns();
    sweep_motors(model, plan, most_turns, |sweep| survey.follow(sweep));
    if model.motors.len() > 1 {
        survey.visit_combinations();
    }
    survey.push_outwards();
    survey.corners()
}

/// A mechanism that is moved, and the outermost that was seen of it.
struct Survey<'a> {
    program: &'a Program,
    seen: SeenPoints,
    machine: Machine<'a, f64>,
    /// The values of each motor that are tried.
    ranges: Vec<[f64; 2]>,
    /// Whether a motor may not leave these.
    limited: Vec<bool>,
    sides: Sides,
    /// For each side the position that reaches farthest out.
    outermost: [Position<f64>; 4],
    /// Operations for one position.
    cost: usize,
}

impl<'a> Survey<'a> {
    fn new(model: &Model, program: &'a Program, shapes: &[Vec<Reach>]) -> Self {
        let seen = SeenPoints::new(model, program, shapes);
        let live = program.live.iter().filter(|live| **live).count();
        let size = model.size();
        let range = |(motor, start): (&Motor, &f64)| match motor.range {
            Some(range) => [range.low, range.high],
            None => match model.joint(motor.joint).kind {
                JointKind::Revolute(..) => [start - 0.5 * TAU, start + 0.5 * TAU],
                _ => [start - size, start + size],
            },
        };
        let machine = Machine::new(program);
        let mut survey = Self {
            program,
            cost: live + seen.count() + 1,
            sides: EMPTY,
            outermost: std::array::from_fn(|_| machine.position().clone()),
            ranges: model
                .motors
                .iter()
                .zip(&program.start.motors)
                .map(range)
                .collect(),
            limited: model
                .motors
                .iter()
                .map(|motor| motor.range.is_some())
                .collect(),
            machine,
            seen,
        };
        survey.look();
        survey
    }

    /// How far a motor is turned at most.
    fn most_turns(&self) -> MostTurns {
        if self.program.watches.is_empty() && self.program.follows.is_empty() {
            return MostTurns::OfMotor(MOST_TURNS);
        }
        let turns = BUDGET_OF_PIECES / (PIECES * self.cost);
        MostTurns::OfFastest(i64::try_from(turns).map_or(MOST_TURNS, |turns| turns.min(MOST_TURNS)))
    }

    /// Notes how far out is what is seen where the machine is.
    fn look(&mut self) {
        let position = self.machine.position();
        let sides = self.seen.sides(&position.poses);
        for side in SIDES {
            if sides[side] > self.sides[side] {
                self.sides[side] = sides[side];
                self.outermost[side] = position.clone();
            }
        }
    }

    /// Moves along a sweep from the start; returns whether it reached the end.
    fn follow(&mut self, sweep: &Sweep) -> bool {
        let Sweep {
            displacements,
            turns,
        } = sweep;
        let affordable = BUDGET / (self.cost * turns * displacements.len()).max(1);
        let samples = turns * affordable.clamp(SAMPLES[0], SAMPLES[1]);
        self.machine = Machine::new(self.program);
        (1..=samples).all(|sample| {
            #[expect(clippy::cast_precision_loss, reason = "a few thousand samples")]
            let part = sample as f64 / samples as f64;
            let target = interpolate(&self.program.start.motors, displacements, part);
            self.visit(&target)
        })
    }

    /// Moves towards a target as far as it can and looks; returns whether it came there.
    fn visit(&mut self, target: &[f64]) -> bool {
        let came = matches!(self.machine.move_toward(target), Ok(None));
        self.look();
        came
    }

    /// Moves to combinations of the motors' values, evenly distributed.
    fn visit_combinations(&mut self) {
        self.machine = Machine::new(self.program);
        let mut points = Halton::default();
        for _ in 0..(BUDGET / self.cost).clamp(TOGETHER[0], TOGETHER[1]) {
            let ranges = self.ranges.iter().enumerate();
            let target: Vec<f64> = ranges
                .map(|(motor, [low, high])| low + (high - low) * points.at(motor))
                .collect();
            self.visit(&target);
            points.advance();
        }
    }

    /// From the outermost position on each side it goes farther out as long as it can, in ever shorter steps.
    fn push_outwards(&mut self) {
        let moves = self.cost * SIDES.len() * 2 * self.ranges.len();
        let rounds = (BUDGET / moves.max(1)).min(ROUNDS);
        for side in SIDES {
            let mut part = FIRST_STEP;
            for _ in 0..rounds {
                for motor in 0..self.ranges.len() {
                    self.push(side, motor, part);
                }
                part *= 0.5;
            }
        }
    }

    /// Moves one motor by a part of what is tried of it, both ways, from where a side is outermost.
    fn push(&mut self, side: usize, motor: usize, part: f64) {
        let [low, high] = self.ranges[motor];
        for step in [part, -part] {
            let from = self.outermost[side].clone();
            let mut target = from.motors.clone();
            target[motor] += step * (high - low);
            if self.limited[motor] {
                target[motor] = target[motor].clamp(low, high);
            }
            self.machine.put_back(from);
            self.visit(&target);
        }
    }

    fn corners(&self) -> [[f64; 2]; 2] {
        let [left, lower, right, upper] =
            SIDES.map(|side| self.sides[side].max(self.seen.ground[side]));
        if left == f64::NEG_INFINITY {
            return [[0.0; 2]; 2];
        }
        [[-left, -lower], [right, upper]]
    }
}
