//! The motion of one motor, sampled once for everything that is measured.

use super::subject::{Named, Subject};
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointKind, Model};
use mech_compiler::program::Program;
use mech_test_support::{Dice, apart, differences, with_ground};
use std::f64::consts::PI;

/// So many steps are made, from one end of a motor's values to the other.
const STEPS: usize = 4000;

/// After so many it is compared with other ways.
const STEPS_BESIDE: usize = 50;

/// On the way to where the others stand so many.
const STEPS_BEFORE: u32 = 50;

/// The machine at a place to which the motors go together, or one after the other; none if they do not come there.
pub(super) fn at<'p>(program: &'p Program, place: &[f64]) -> Option<Machine<'p, f64>> {
    let mut machine = Machine::new(program);
    if machine.move_to(place).is_err() {
        let mut values = program.start.motors.clone();
        for (motor, goal) in place.iter().enumerate() {
            values[motor] = *goal;
            machine.move_to(&values).ok()?;
        }
    }
    Some(machine)
}

/// The values of a motor between which it certainly goes, from a place where it is at its start.
pub(crate) fn reach(model: &Model, program: &Program, from: &[f64], motor: usize) -> [f64; 2] {
    let start = from[motor];
    if let Some(range) = model.motors[motor].range {
        return [range.low, range.high];
    }
    let far = match model.joint(model.motors[motor].joint).kind {
        JointKind::Revolute(..) => PI,
        _ => 0.5 * model.size(),
    };
    [-far, far].map(|far| {
        let mut machine = at(program, from).expect("it was there");
        let mut goal = from.to_vec();
        goal[motor] = start + far;
        machine.move_toward(&goal).expect("finite values");
        // Beside a dead point everything is fast.
        start + 0.9 * (machine.position().motors[motor] - start)
    })
}

/// One motor of a mechanism, between two values, while the others stand.
pub(super) struct Sweep<'m> {
    pub(super) model: &'m Model,
    pub(super) program: &'m Program,
    pub(super) motor: usize,
    /// Where the others stand.
    pub(super) from: Vec<f64>,
    ends: [f64; 2],
    /// Whether links are in the same places if all motors go there at once. Where a loop passes change points, the way decides: what sums up
    /// the motion is then taken over all ways, of which this is one.
    pub(super) is_only_way: bool,
    /// For each subject its value at each step, in ascending order of the motor.
    values: Vec<Vec<f64>>,
}

impl<'m> Sweep<'m> {
    /// Of any motor, where half of the others stand elsewhere than at their start; none if nothing can move.
    pub(super) fn any(
        model: &'m Model,
        program: &'m Program,
        subjects: &[Named],
        dice: &mut Dice,
    ) -> Option<Self> {
        let motor = dice.below(model.motors.len());
        let mut from = program.start.motors.clone();
        for other in (0..model.motors.len()).filter(|other| *other != motor) {
            if dice.once_in(2) {
                continue;
            }
            let ends = reach(model, program, &from, other);
            let mut place = from.clone();
            place[other] = dice.between(ends[0], ends[1]);
            if at(program, &place).is_some() {
                from = place;
            }
        }
        let ends = reach(model, program, &from, motor);
        let mut sweep = Self {
            model,
            program,
            motor,
            from,
            ends,
            is_only_way: true,
            values: vec![vec![f64::NAN; STEPS + 1]; subjects.len()],
        };
        (ends[1] > ends[0]).then(|| sweep.run(subjects))??;
        Some(sweep)
    }

    /// The value of the motor at a step.
    pub(super) fn at(&self, step: usize) -> f64 {
        let [low, high] = self.ends;
        #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
        let part = step as f64 / STEPS as f64;
        low + (high - low) * part
    }

    /// How far the motor goes with a step.
    pub(super) fn step(&self) -> f64 {
        self.at(1) - self.at(0)
    }

    /// The step that is nearest to a value of the motor.
    pub(super) fn nearest(&self, value: f64) -> usize {
        let above = (0..=STEPS).find(|step| self.at(*step) >= value);
        above.unwrap_or(STEPS)
    }

    /// The first and the last of some steps in a row: of all, or of many.
    pub(super) fn span(dice: &mut Dice) -> [usize; 2] {
        // Differences need two steps more on each side.
        let [first, last] = [2, STEPS - 2];
        if dice.once_in(2) {
            return [first, last];
        }
        let long = STEPS / 20 + dice.below(STEPS / 2);
        let low = first + dice.below(last - first - long);
        // Their number is that of a rule of Simpson's with half of them.
        [low, low + long / 4 * 4]
    }

    /// The values of a subject.
    pub(super) fn values(&self, subject: usize) -> &[f64] {
        &self.values[subject]
    }

    /// Goes along it, both ways from the start.
    fn run(&mut self, subjects: &[Named]) -> Option<()> {
        let start = self.from[self.motor];
        let first = (0..=STEPS).find(|step| self.at(*step) >= start)?;
        let mut machine = Machine::new(self.program);
        let mut seen = vec![None; subjects.len()];
        let origin = self.program.start.motors.clone();
        for step in 0..=STEPS_BEFORE {
            let part = f64::from(step) / f64::from(STEPS_BEFORE);
            let motors = origin.iter().zip(&self.from);
            let motors: Vec<f64> = motors.map(|(a, b)| a + (b - a) * part).collect();
            machine.move_to(&motors).ok()?;
            self.look(subjects, &machine, &mut seen);
        }
        let beside = (machine.position().clone(), seen);
        let up: Vec<usize> = (first..=STEPS).collect();
        let down: Vec<usize> = (0..first).rev().collect();
        for steps in [up, down] {
            machine.put_back(beside.0.clone());
            let mut seen = beside.1.clone();
            for step in steps {
                let mut goal = self.from.clone();
                goal[self.motor] = self.at(step);
                machine.move_to(&goal).expect("it goes there");
                self.look(subjects, &machine, &mut seen);
                if step % STEPS_BESIDE == 0 {
                    self.is_only_way &= self.is_there(&machine);
                }
                for (values, seen) in self.values.iter_mut().zip(&seen) {
                    values[step] = seen.unwrap_or(f64::NAN);
                }
            }
        }
        Some(())
    }

    /// Whether links are where they are if all motors go there at once.
    fn is_there(&self, machine: &Machine<'_, f64>) -> bool {
        let position = machine.position();
        let other = at(self.program, &position.motors);
        let other = other.map(|other| other.position().poses.clone());
        other
            .is_some_and(|other| apart(&other, &position.poses) < 1e-6 * self.model.size().max(1.0))
    }

    fn look(&self, subjects: &[Named], machine: &Machine<'_, f64>, seen: &mut [Option<f64>]) {
        let poses = with_ground(self.model, &machine.position().poses);
        for ((_, subject), seen) in subjects.iter().zip(seen) {
            *seen = Some(subject.seen(self.model, &poses, *seen));
        }
    }

    /// A subject where the motors have other values, near to a value.
    pub(super) fn visit(&self, subject: Subject, place: &[f64], near: f64) -> Option<f64> {
        let machine = at(self.program, place)?;
        Some(subject.of(self.model, &machine.position().poses, Some(near)))
    }

    /// How fast a subject changes with the motor at a place, and how much that is in doubt.
    pub(super) fn slope_at(&self, subject: Subject, place: &[f64], near: f64) -> Option<[f64; 2]> {
        // Beside a place where the mechanism stops only short steps are possible on both sides.
        let mut steps = (0..6).map(|times| self.step().min(1e-3) * 0.25_f64.powi(times));
        steps.find_map(|step| self.slope_by(subject, (place, near), step))
    }

    /// The same by differences of this step.
    fn slope_by(
        &self,
        subject: Subject,
        (place, near): (&[f64], f64),
        step: f64,
    ) -> Option<[f64; 2]> {
        let mut values = [0.0; 9];
        for (value, steps) in
            values.iter_mut().zip([-4.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0_f64])
        {
            let mut beside = place.to_vec();
            beside[self.motor] += steps * step;
            *value = self.visit(subject, &beside, near)?;
        }
        Some(slope(&values, step))
    }
}

/// The slope in the middle of nine values, a step from each other, and how much it is in doubt.
pub(super) fn slope(values: &[f64; 9], step: f64) -> [f64; 2] {
    let [a, _, b, c, d, e, f, _, g] = *values;
    let [fine, _] = differences([b, c, d, e, f], step);
    let [rough, _] = differences([a, b, d, f, g], 2.0 * step);
    [fine, (fine - rough).abs()]
}
