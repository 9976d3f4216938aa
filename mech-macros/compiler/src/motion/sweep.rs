//! Sweeps: the straight displacements of the motors by which a mechanism is tried at compile time. Each motor goes alone through its
//! range, or through whole turns; then all go together in several proportions. Each sweep begins at the start.

use crate::bug::bug;
use crate::model::{JointKind, Model, MotorId};
use crate::plan::{Plan, Rational, Source, Step};
use num_traits::{Signed, ToPrimitive};
use std::f64::consts::TAU;

/// Most turns of the fastest link that are examined one by one.
const MOST_TURNS_OF_FASTEST: usize = 64;

/// A straight displacement of all motors from the start.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sweep {
    /// The displacement of each motor, and after these of each param, in radians or scene units.
    pub(super) displacements: Vec<f64>,
    /// How many turns the fastest link makes: so many times the samples of a single turn are taken.
    pub(super) turns: usize,
}

/// The values of the motors after a part of their displacements from the start.
pub(super) fn interpolate(start: &[f64], displacements: &[f64], part: f64) -> Vec<f64> {
    let pairs = start.iter().zip(displacements);
    pairs
        .map(|(start, displacement)| start + displacement * part)
        .collect()
}

/// Makes all sweeps, of at most so many turns of a motor: behind gears it takes several until everything has turned. `run` moves the
/// mechanism along a sweep and returns whether it reached the end: a motor that can turn all the way round need not turn back.
pub(super) fn sweep_motors(
    model: &Model,
    plan: &Plan,
    most_turns: i64,
    mut run: impl FnMut(&Sweep) -> bool,
) {
    for motor in model.motor_ids() {
        sweep_alone(model, plan, (motor, most_turns), &mut run);
    }
    if model.motors.len() > 1 {
        sweep_together(model, &mut run);
    }
}

/// Moves one motor through its range, the others at the start.
fn sweep_alone(
    model: &Model,
    plan: &Plan,
    (motor, most_turns): (MotorId, i64),
    run: &mut impl FnMut(&Sweep) -> bool,
) {
    let index = motor.index();
    let start = plan.start.motors[index];
    let sweep = |displacement: f64, turns: usize| {
        let mut displacements = vec![0.0; model.inputs()];
        displacements[index] = displacement;
        Sweep {
            displacements,
            turns,
        }
    };
    if let Some(range) = model.motor(motor).range {
        run(&sweep(range.high - start, 1));
        run(&sweep(range.low - start, 1));
        return;
    }
    let is_revolute = matches!(
        model.joint(model.motor(motor).joint).kind,
        JointKind::Revolute(..)
    );
    let (displacement, turns_of_fastest) = if is_revolute {
        let (turns, turns_of_fastest) = turns_of(plan, motor, most_turns);
        #[expect(clippy::cast_precision_loss, reason = "some hundred turns")]
        let displacement = TAU * turns as f64;
        (displacement, turns_of_fastest)
    } else {
        (4.0 * model.size(), 2)
    };
    let reached_end = run(&sweep(displacement, turns_of_fastest));
    if !(reached_end && is_revolute) {
        run(&sweep(-displacement, turns_of_fastest));
    }
}

/// Moves all motors together, in several proportions.
fn sweep_together(model: &Model, run: &mut impl FnMut(&Sweep) -> bool) {
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
        run(&Sweep {
            displacements: displacements.chain(of_params).collect(),
            turns: 1,
        });
    }
}

/// How many turns of a motor it takes until everything behind gears and cams has turned as a whole, and how many turns the fastest
/// of it makes meanwhile.
fn turns_of(plan: &Plan, motor: MotorId, most_turns: i64) -> (i64, usize) {
    let parts = plan.steps.iter().flat_map(|step| match step {
        Step::Mesh(mesh) => &mesh.parts[..],
        Step::Cam(cam) => &cam.parts[..],
        _ => &[],
    });
    let own = parts.filter(|(source, _)| plan.sources[*source] == Source::Motor(motor));
    let own: Vec<&Rational> = own.map(|(_, part)| part).collect();
    let turns = own.iter().fold(1, |turns, part| {
        // One that is larger is beyond the most that is walked anyway.
        let denominator = part.denom().to_i64().unwrap_or(most_turns);
        num_integer::lcm(turns, denominator.clamp(1, most_turns)).min(most_turns)
    });
    // A ratio beyond 2^64 counts as the greatest number there is.
    let fastest = own.iter().map(|part| part.abs().ceil().to_integer());
    let fastest = fastest
        .map(|part| part.to_usize().unwrap_or(usize::MAX))
        .max()
        .unwrap_or(1);
    let Ok(whole) = usize::try_from(turns) else {
        bug!("a motor makes {turns} turns");
    };
    let turns_of_all = whole.saturating_mul(fastest.max(1));
    (turns, turns_of_all.clamp(1, MOST_TURNS_OF_FASTEST))
}
