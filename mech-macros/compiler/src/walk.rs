//! The ways on which a mechanism is tried at compile time: each motor alone through its range, or through whole turns, and all
//! of them together in several proportions, always straight from the start.

use crate::bug::bug;
use crate::model::{JointKind, Model, MotorId};
use crate::plan::{Plan, Rational, Source, Step};
use num_traits::{Signed, ToPrimitive};
use std::f64::consts::TAU;

/// Most turns of whatever turns fastest that are looked at one by one.
const MOST_PIECES: usize = 64;

/// A straight way from the start.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stretch {
    /// How far each motor goes on it, and each param.
    pub(crate) ways: Vec<f64>,
    /// How many times as many samples as a single turn it is worth.
    pub(crate) pieces: usize,
}

/// The values of the motors after a part of the ways from where they start.
pub(crate) fn at(start: &[f64], ways: &[f64], part: f64) -> Vec<f64> {
    let ways = start.iter().zip(ways);
    ways.map(|(start, way)| start + way * part).collect()
}

/// Walks all ways, no more than so many turns of a motor: behind gears it takes several until everything has turned. The walker is
/// given a stretch and tells whether it came to its end: who can turn all the way round need not turn back as well.
pub(crate) fn walk(
    model: &Model,
    plan: &Plan,
    most_turns: i64,
    mut walker: impl FnMut(&Stretch) -> bool,
) {
    for motor in model.motor_ids() {
        alone(model, plan, (motor, most_turns), &mut walker);
    }
    if model.motors.len() > 1 {
        together(model, &mut walker);
    }
}

/// Moves one motor through its range, the others at the start.
fn alone(
    model: &Model,
    plan: &Plan,
    (motor, most_turns): (MotorId, i64),
    walker: &mut impl FnMut(&Stretch) -> bool,
) {
    let index = motor.index();
    let start = plan.start.motors[index];
    let along = |way: f64, pieces: usize| {
        let mut ways = vec![0.0; model.inputs()];
        ways[index] = way;
        Stretch { ways, pieces }
    };
    if let Some(range) = model.motor(motor).range {
        walker(&along(range.high - start, 1));
        walker(&along(range.low - start, 1));
        return;
    }
    let turns = matches!(
        model.joint(model.motor(motor).joint).kind,
        JointKind::Revolute(..)
    );
    let (way, pieces) = if turns {
        let (turns, pieces) = turns_of(plan, motor, most_turns);
        #[expect(clippy::cast_precision_loss, reason = "some hundred turns")]
        let way = TAU * turns as f64;
        (way, pieces)
    } else {
        (4.0 * model.size(), 2)
    };
    let whole = walker(&along(way, pieces));
    if !(whole && turns) {
        walker(&along(-way, pieces));
    }
}

/// Moves all motors together, in several proportions.
fn together(model: &Model, walker: &mut impl FnMut(&Stretch) -> bool) {
    for round in 1_u32..=4 {
        let ways = (0_u32..).zip(&model.motors).map(|(index, motor)| {
            let part = f64::from((round * (2 * index + 3)) % 7) / 3.0 - 1.0;
            let whole = match model.joint(motor.joint).kind {
                JointKind::Revolute(..) => TAU,
                _ => model.size(),
            };
            part * whole
        });
        let rests = model.params.ids().map(|_| 0.0);
        walker(&Stretch {
            ways: ways.chain(rests).collect(),
            pieces: 1,
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
    // One that no usize holds, beyond 2^64 turns, is left out.
    let fastest = own.iter().map(|part| part.abs().ceil().to_integer());
    let fastest = fastest
        .filter_map(|part| part.to_usize())
        .max()
        .unwrap_or(1);
    let Ok(whole) = usize::try_from(turns) else {
        bug!("a motor makes {turns} turns");
    };
    let turns_of_all = whole.saturating_mul(fastest.max(1));
    (turns, turns_of_all.clamp(1, MOST_PIECES))
}
