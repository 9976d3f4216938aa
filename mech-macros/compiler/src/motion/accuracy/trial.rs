//! Moves programs beside the exact one, step by step as it was declared, and looks how far they are off.
//!
//! An iteration begins where the last position was, and squares what is left in each round: after two steps nothing is left of
//! what was before. So not every step of a turn has to be made: here and there along the ways of [sweeps](crate::motion::sweep) two are,
//! forwards and backwards, from where the mechanism exactly is.

use crate::cost;
use crate::evaluate::Machine;
use crate::model::{JointKind, LinkId, Model};
use crate::motion::sweep::{MostTurns, Sweep, interpolate, sweep_motors};
use crate::plan::Plan;
use crate::program::{Position, Program};
use mech_core::Real;
use std::f64::consts::TAU;

/// The number of operations that a trial may cost.
const BUDGET: usize = 1_200_000;
/// The operations that moves of the exact program may cost where they go in pieces.
const BUDGET_OF_PIECES: usize = 8_000_000;
/// Turns of a motor: what is read of more turns is read of their rest.
const MOST_TURNS: i64 = 8;
/// Samples in a turn.
const SAMPLES: [usize; 2] = [24, 180];
/// Samples where all motors wander about.
const WANDERING: [usize; 2] = [240, 600];
/// Parts of it are never near each other.
const GOLDEN: f64 = 0.618_033_988_749_895;
/// The distances from the end of a range at which rounding is looked at, as parts of a sample.
const NEAR_THE_END: [f64; 5] = [0.25, 0.063, 0.016, 0.004, 0.001];
/// Steps from a sample.
const STEPS: usize = 2;
/// Where several motors step at once: the most ways of doing so that are tried.
const MOST_PATTERNS: usize = 16;

/// A program that may be less exact than another.
#[derive(Clone, Debug)]
pub(super) struct Rival {
    pub(super) program: Program,
    /// The greatest error of each link.
    pub(super) worst: Vec<f64>,
    /// Whether it stopped where the other one moved.
    pub(super) stopped: bool,
}

impl Rival {
    pub(super) fn new(program: Program) -> Self {
        Self { worst: vec![0.0; program.poses.len()], stopped: false, program }
    }

    /// Returns the greatest error of any link; infinite if it stopped.
    pub(super) fn error(&self) -> f64 {
        if self.stopped {
            return f64::INFINITY;
        }
        self.worst.iter().copied().fold(0.0, f64::max)
    }
}

/// The findings about the exact program.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Exact {
    /// The greatest error of each link in single precision.
    pub(super) single: Vec<f64>,
    /// Whether single precision was of any use.
    pub(super) seen: bool,
    /// The greatest number that it takes to say where everything is.
    pub(super) reach: f64,
}

/// Tries all rivals of a program.
pub(super) fn compare(model: &Model, plan: &Plan, exact: &Program, rivals: &mut [Rival]) -> Exact {
    let patterns = patterns(model);
    let operations = |program: &Program| {
        let live = program.live.iter().filter(|live| **live).count();
        let cost = cost::of_program(program);
        live.max((cost.additions + cost.multiplications) as usize)
    };
    let steps = STEPS * patterns.len();
    let per_sample = operations(exact) * (2 + steps)
        + rivals.iter().map(|rival| steps * operations(&rival.program)).sum::<usize>();
    let extents = Extents::of(model, &exact.stored);
    let mut trial = Trial {
        affordable: BUDGET / (per_sample * model.motors.len()).max(1),
        left: BUDGET_OF_PIECES,
        found: Exact {
            single: vec![0.0; exact.poses.len()],
            seen: false,
            reach: extents.reach(&exact.start),
        },
        extents,
        patterns,
        exact,
        machine: Machine::new(exact),
        single: Machine::new(exact),
        rivals,
    };
    sweep_motors(model, plan, MostTurns::OfMotor(MOST_TURNS), |sweep| trial.follow(sweep));
    if model.motors.len() > 1 {
        trial.wander(model);
    }
    trial.found
}

/// The steps that are tried: of each motor alone, and of several at once.
fn patterns(model: &Model) -> Vec<Vec<f64>> {
    let steps: Vec<f64> = model
        .motors
        .iter()
        // A motor without a declared step is not moved.
        .map(|motor| motor.step.unwrap_or(0.0))
        .collect();
    let moved: Vec<usize> = (0..steps.len()).filter(|&motor| steps[motor] > 0.0).collect();
    let alone = moved.iter().flat_map(|&motor| {
        [1.0, -1.0].map(|sign| {
            let mut pattern = vec![0.0; steps.len()];
            pattern[motor] = sign * steps[motor];
            pattern
        })
    });
    let together = (0_usize..1 << moved.len().min(4)).filter(|_| moved.len() > 1);
    let together = together.map(|signs| {
        let step = |(motor, step): (usize, &f64)| {
            let back = signs >> (motor % 4) & 1 == 1;
            if back { -step } else { *step }
        };
        steps.iter().enumerate().map(step).collect()
    });
    // Several at once are worse: these come first.
    let mut patterns: Vec<Vec<f64>> = together.collect();
    patterns.extend(alone);
    patterns.truncate(MOST_PATTERNS);
    patterns
}

struct Trial<'a, 'p> {
    affordable: usize,
    /// The operations that are left.
    left: usize,
    patterns: Vec<Vec<f64>>,
    extents: Extents,
    exact: &'p Program,
    machine: Machine<'p, f64>,
    single: Machine<'p, f32>,
    rivals: &'a mut [Rival],
    found: Exact,
}

impl Trial<'_, '_> {
    /// Follows the exact program along a sweep; returns whether it reached the end.
    fn follow(&mut self, sweep: &Sweep) -> bool {
        let Sweep { displacements, turns } = sweep;
        let samples = turns * (self.affordable / turns).clamp(SAMPLES[0], SAMPLES[1]);
        let start = &self.exact.start;
        let mut machine = Machine::<f64>::new(self.exact);
        self.try_around(machine.position(), 0..self.patterns.len());
        for sample in 1..=samples {
            #[expect(clippy::cast_precision_loss, reason = "a few thousand samples")]
            let part = sample as f64 / samples as f64;
            let motors = representable(interpolate(&start.motors, displacements, part));
            let before = machine.position().clone();
            let Some(came) = self.pay(&mut machine, &motors) else {
                return false;
            };
            if came {
                self.in_single(&before, machine.position());
                self.try_around(machine.position(), 0..self.patterns.len());
            } else {
                self.end(&mut machine, &motors);
                return false;
            }
        }
        true
    }

    /// Moves the exact program; returns whether it came there, or none if that costs more than is left.
    fn pay(&mut self, machine: &mut Machine<'_, f64>, motors: &[f64]) -> Option<bool> {
        machine.allow(self.left);
        let came = machine.move_to(motors).is_ok();
        self.left = machine.left();
        machine.allow(usize::MAX);
        (self.left > 0).then_some(came)
    }

    /// Wanders about with all motors, turning back where it is blocked.
    fn wander(&mut self, model: &Model) {
        let size = model.size();
        let reach: Vec<f64> = model
            .motors
            .iter()
            .map(|motor| match model.joint(motor.joint).kind {
                JointKind::Revolute(..) => f64::INFINITY,
                _ => 4.0 * size,
            })
            .collect();
        let start = &self.exact.start.motors;
        // Each at a pace of its own, so that they meet everywhere.
        let mut paces: Vec<f64> = (1_u32..)
            .zip(&reach)
            .map(|(motor, reach)| {
                let whole = if reach.is_finite() { size } else { TAU };
                whole * (0.02 + 0.06 * (GOLDEN * f64::from(motor)).fract())
            })
            .collect();
        let mut machine = Machine::<f64>::new(self.exact);
        let samples = (4 * self.affordable).clamp(WANDERING[0], WANDERING[1]);
        for sample in 0..samples {
            let turned = sample % paces.len();
            let before = machine.position().clone();
            let next = representable(interpolate(&before.motors, &paces, 1.0));
            let inside = |(motor, next): (usize, &f64)| {
                let range = model.motors[motor].range;
                range.is_none_or(|range| range.low <= *next && *next <= range.high)
                    && (next - start[motor]).abs() <= reach[motor]
            };
            if !next.iter().enumerate().all(inside) {
                for pace in &mut paces {
                    *pace = -*pace;
                }
                paces[turned] = -paces[turned];
                continue;
            }
            let Some(came) = self.pay(&mut machine, &next) else {
                return;
            };
            if came {
                self.in_single(&before, machine.position());
            } else {
                self.end(&mut machine, &next);
                paces[turned] = -paces[turned];
            }
            let count = self.patterns.len().max(1);
            self.try_around(
                machine.position(),
                [sample % count, (7 * sample + 3) % count].into_iter(),
            );
        }
    }

    /// Goes as near to the end of its way as it can, closer and closer: errors are greatest there, and so is rounding.
    fn end(&mut self, machine: &mut Machine<'_, f64>, motors: &[f64]) {
        let before = machine.position().clone();
        let _ = machine.move_toward(motors);
        let end = machine.position().clone();
        self.try_around(&end, 0..self.patterns.len());
        self.back_to(&end);
        let back: Vec<f64> =
            motors.iter().zip(&before.motors).map(|(there, here)| here - there).collect();
        for part in NEAR_THE_END {
            machine.put_back(before.clone());
            if machine.move_to(&representable(interpolate(&end.motors, &back, part))).is_ok() {
                self.in_single(&before, machine.position());
            }
        }
        machine.put_back(end);
    }

    /// Goes there in single precision.
    fn in_single(&mut self, before: &Position<f64>, there: &Position<f64>) {
        self.found.reach = self.found.reach.max(self.extents.reach(there));
        self.single.put_back(to_single_precision(before));
        let motors: Vec<f32> = there.motors.iter().map(|&motor| f32::from_f64(motor)).collect();
        if self.single.move_to(&motors).is_err() {
            return;
        }
        self.found.seen = true;
        let off = self.extents.displacements(self.single.position(), there);
        note(&mut self.found.single, off);
    }

    /// Steps away from a position in some directions.
    fn try_around(&mut self, position: &Position<f64>, directions: impl Iterator<Item = usize>) {
        if self.rivals.iter().all(|rival| rival.stopped) {
            return;
        }
        for pattern in directions.map(|direction| &self.patterns[direction]) {
            let mut positions = Vec::with_capacity(STEPS);
            self.machine.put_back(position.clone());
            for step in 1..=STEPS {
                let motors = step_motors(position, pattern, step);
                if self.machine.move_to(&motors).is_err() {
                    // Where the whole motion is shorter than a step, it goes to its end.
                    if step == 1 && self.machine.move_toward(&motors).is_ok() {
                        positions.push(self.machine.position().clone());
                    }
                    break;
                }
                positions.push(self.machine.position().clone());
            }
            for rival in self.rivals.iter_mut().filter(|rival| !rival.stopped) {
                try_rival(rival, position, &positions, &self.extents);
            }
        }
    }

    /// Steps from all directions to a position.
    fn back_to(&mut self, position: &Position<f64>) {
        for pattern in &self.patterns {
            self.machine.put_back(position.clone());
            let motors = step_motors(position, pattern, 1);
            // As far as it can, if that is less.
            if self.machine.move_toward(&motors).is_err() {
                continue;
            }
            for rival in self.rivals.iter_mut().filter(|rival| !rival.stopped) {
                let away = self.machine.position();
                try_rival(rival, away, std::slice::from_ref(position), &self.extents);
            }
        }
    }
}

/// Steps a rival from a position through others.
fn try_rival(
    rival: &mut Rival,
    from: &Position<f64>,
    through: &[Position<f64>],
    extents: &Extents,
) {
    let mut machine = Machine::<f64>::new(&rival.program);
    machine.put_back(from.clone());
    for position in through {
        if machine.move_to(&position.motors).is_err() {
            rival.stopped = true;
            return;
        }
        let off = extents.displacements(machine.position(), position);
        note(&mut rival.worst, off);
    }
}

fn note(worst: &mut [f64], off: impl Iterator<Item = f64>) {
    for (worst, off) in worst.iter_mut().zip(off) {
        *worst = worst.max(off);
    }
}

/// The motors after so many steps.
fn step_motors(position: &Position<f64>, pattern: &[f64], steps: usize) -> Vec<f64> {
    #[expect(clippy::cast_precision_loss, reason = "a few steps")]
    let steps = steps as f64;
    interpolate(&position.motors, pattern, steps)
}

/// The nearest values that both precisions have.
fn representable(motors: Vec<f64>) -> Vec<f64> {
    let nearest = |motor: f64| f32::from_f64(motor).to_f64();
    motors.into_iter().map(nearest).collect()
}

fn to_single_precision(position: &Position<f64>) -> Position<f32> {
    let number = |number: &f64| f32::from_f64(*number);
    Position {
        motors: position.motors.iter().map(number).collect(),
        turns: position.turns.clone(),
        poses: position.poses.iter().map(|pose| pose.map(f32::from_f64)).collect(),
        state: position.state.iter().map(number).collect(),
    }
}

/// For each link whose pose is kept, the corners of a box around its axes and shapes. When the link is off, no place in the box is
/// farther off than one of the corners.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Extents(Vec<[[f64; 2]; 4]>);

impl Extents {
    pub(super) fn of(model: &Model, stored: &[LinkId]) -> Self {
        let corners = stored.iter().map(|&id| {
            let mut low = [f64::INFINITY; 2];
            let mut high = [f64::NEG_INFINITY; 2];
            // A circle is where its middle is.
            let in_shapes = model.link(id).shape_points().map(|(point, _)| point);
            for point in model.axis_places(id).chain(in_shapes) {
                for index in 0..2 {
                    low[index] = low[index].min(point[index]);
                    high[index] = high[index].max(point[index]);
                }
            }
            if low[0] > high[0] {
                return [[0.0; 2]; 4];
            }
            [low, [low[0], high[1]], [high[0], low[1]], high]
        });
        Self(corners.collect())
    }

    /// Returns the greatest error of a place on each link.
    pub(super) fn displacements<T: Real>(
        &self,
        is: &Position<T>,
        should: &Position<f64>,
    ) -> impl Iterator<Item = f64> {
        let poses = is.poses.iter().zip(&should.poses).zip(&self.0);
        poses.map(|((is, should), corners)| {
            let mut off = [0.0; 4];
            for ((off, is), should) in off.iter_mut().zip(is).zip(should) {
                *off = is.to_f64() - should;
            }
            let [cos, sin, x, y] = off;
            let moved = |[a, b]: [f64; 2]| (x + cos * a - sin * b).hypot(y + sin * a + cos * b);
            corners.iter().copied().map(moved).fold(0.0, f64::max)
        })
    }

    /// The greatest of the numbers that it takes to say where the links are: rounding is relative to these.
    pub(super) fn reach(&self, position: &Position<f64>) -> f64 {
        let spots = self.0.iter().flatten().flatten();
        let origins = position.poses.iter().flat_map(|pose| &pose[2..]);
        let motors = &position.motors;
        spots.chain(origins).chain(motors).fold(0.0, |reach, number| reach.max(number.abs()))
    }
}
