//! Sweeps: the straight displacements of the motors by which a mechanism is tried at compile time. Each motor goes alone through its
//! range, or through whole turns; then all go together in several proportions. Each sweep begins at the start.

use crate::model::{JointKind, Model, MotorId};
use crate::plan::{Plan, Rational, Source, Step};
use num_traits::{Signed, ToPrimitive};
use std::f64::consts::TAU;

/// Most turns of the fastest link that are examined one by one.
const MOST_TURNS_OF_FASTEST: f64 = 64.0;
/// A slide takes as many samples as so many turns.
const TURNS_OF_SLIDE: usize = 2;

/// A straight displacement of all motors from the start.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sweep {
    /// The displacement of each motor, and after these of each param, in radians or scene units.
    pub(crate) displacements: Vec<f64>,
    /// The number of turns that the fastest link makes. Each of them takes the samples of one turn.
    pub(crate) turns: usize,
}

/// The greatest number of turns of a motor.
#[derive(Clone, Copy, Debug)]
pub(crate) enum MostTurns {
    /// So many turns of the motor itself.
    OfMotor(i64),
    /// As many turns as let the fastest part that it drives turn so often, but one at least.
    OfFastest(i64),
}

impl MostTurns {
    /// The turns of a motor that drives these parts of its turns.
    fn of(self, parts: &[&Rational]) -> i64 {
        match self {
            Self::OfMotor(turns) => turns,
            #[expect(clippy::cast_possible_truncation, reason = "rounded down on purpose")]
            #[expect(clippy::cast_precision_loss, reason = "some thousand turns")]
            Self::OfFastest(turns) => ((turns as f64 / fastest(parts)) as i64).max(1),
        }
    }
}

/// The values of the motors after a part of their displacements from the start.
pub(crate) fn interpolate(start: &[f64], displacements: &[f64], part: f64) -> Vec<f64> {
    let pairs = start.iter().zip(displacements);
    pairs.map(|(start, displacement)| start + displacement * part).collect()
}

/// Makes all sweeps, of at most so many turns: behind gears it takes several until everything has turned. `run` moves the mechanism along a
/// sweep and returns whether it reached the end: a motor that can turn all the way round need not turn back.
pub(crate) fn sweep_motors(
    model: &Model,
    plan: &Plan,
    most_turns: MostTurns,
    mut run: impl FnMut(&Sweep) -> bool,
) {
    sweep_each(model, plan, (most_turns, model.size()), &mut run);
    if model.motors.len() > 1 {
        sweep_together(model, &mut run);
    }
}

/// The greatest displacement to either side of a motor that slides without a range, in sizes of the mechanism.
pub(crate) const FARTHEST_SLIDE: f64 = 4.0;

/// Makes the sweeps of each motor alone, of a mechanism of this size.
pub(crate) fn sweep_each(
    model: &Model,
    plan: &Plan,
    farthest: (MostTurns, f64),
    run: &mut impl FnMut(&Sweep) -> bool,
) {
    for motor in model.motor_ids() {
        sweep_alone(model, plan, (motor, farthest), run);
    }
}

/// Moves one motor through its range, the others at the start.
fn sweep_alone(
    model: &Model,
    plan: &Plan,
    (motor, (most_turns, size)): (MotorId, (MostTurns, f64)),
    run: &mut impl FnMut(&Sweep) -> bool,
) {
    let index = motor.index();
    let start = plan.start.motors[index];
    let is_revolute = model.turns(model.motor(motor).joint);
    let parts = parts_of(plan, motor);
    let mut run_to = |displacement: f64| {
        let mut displacements = vec![0.0; model.inputs()];
        displacements[index] = displacement;
        let turns =
            if is_revolute { turns_of_fastest(&parts, displacement / TAU) } else { TURNS_OF_SLIDE };
        run(&Sweep { displacements, turns })
    };
    if let Some(range) = model.motor(motor).range {
        run_to(range.high - start);
        run_to(range.low - start);
        return;
    }
    let displacement = if is_revolute {
        #[expect(clippy::cast_precision_loss, reason = "some thousand turns")]
        let turns = turns_until_whole(&parts, most_turns.of(&parts)) as f64;
        TAU * turns
    } else {
        FARTHEST_SLIDE * size
    };
    let reached_end = run_to(displacement);
    if !(reached_end && is_revolute) {
        run_to(-displacement);
    }
}

/// Moves all motors together, in several proportions.
pub(crate) fn sweep_together(model: &Model, run: &mut impl FnMut(&Sweep) -> bool) {
    for round in 1_u32..=4 {
        let displacements = (0_u32..).zip(&model.motors).map(|(index, motor)| {
            let part = f64::from((round * (2 * index + 3)) % 7) / 3.0 - 1.0;
            let whole = match model.joint(motor.joint).kind {
                JointKind::Revolute(..) => TAU,
                _ => model.size(),
            };
            part * whole
        });
        let of_params = model.params.ids().map(|_| 0.0);
        run(&Sweep { displacements: displacements.chain(of_params).collect(), turns: 1 });
    }
}

/// Returns the turns of everything that a motor drives by gears and cams, in one turn of the motor.
fn parts_of(plan: &Plan, motor: MotorId) -> Vec<&Rational> {
    let parts = plan.steps.iter().flat_map(|step| match step {
        Step::Mesh(mesh) => &mesh.parts[..],
        Step::Cam(cam) => &cam.parts[..],
        _ => &[],
    });
    let own = parts.filter(|(source, _)| plan.sources[*source] == Source::Motor(motor));
    own.map(|(_, part)| part).collect()
}

/// Returns the number of turns of a motor after which everything that it drives has made whole turns.
fn turns_until_whole(parts: &[&Rational], most_turns: i64) -> i64 {
    parts.iter().fold(1, |turns, part| {
        // One that is larger is beyond the most that is examined anyway.
        let denominator = part.denom().to_i64().unwrap_or(most_turns);
        num_integer::lcm(turns, denominator.clamp(1, most_turns)).min(most_turns)
    })
}

/// Returns the number of turns that the fastest makes in so many turns of the motor, as far as they are examined one by one.
fn turns_of_fastest(parts: &[&Rational], turns: f64) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and 64")]
    let turns = (turns.abs() * fastest(parts)).ceil().clamp(1.0, MOST_TURNS_OF_FASTEST) as usize;
    turns
}

/// Returns the number of turns that the fastest makes in one turn of the motor.
fn fastest(parts: &[&Rational]) -> f64 {
    // A ratio beyond the floats is beyond the most that is examined anyway.
    let ratios = parts.iter().map(|part| part.abs().to_f64().unwrap_or(f64::INFINITY));
    ratios.fold(1.0, f64::max)
}
