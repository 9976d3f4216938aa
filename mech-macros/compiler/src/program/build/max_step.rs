//! The greatest displacement of motors in one piece where no bound is known: loops that are solved together could leap over a place where
//! they do not close.

use crate::model::Model;
use crate::plan::{ConnectionKind, Plan, Rational, Source, Step, Unknown, float_of};

/// The largest turn in one piece, in radians.
const TURN: f64 = 0.25;
/// Nothing may slide farther, nor a length change more, as a part of its size.
const PART: f64 = 0.02;

/// The longest displacement of each motor and param in one piece, in radians or scene units: loops that close at both ends of it are not
/// likely to be open between. Where loops are coupled, nothing that a motor drives by rolling goes farther either.
pub(super) fn max_steps(model: &Model, plan: &Plan, is_coupled: bool) -> Vec<f64> {
    let slide = PART * model.size().max(f64::MIN_POSITIVE);
    let most = |turns: bool| if turns { TURN } else { slide };
    let steps = if is_coupled { &plan.steps[..] } else { &[] };
    let rolling: Vec<Rolling<'_>> = steps.iter().flat_map(rolling).collect();
    let motors = model.motor_ids().map(|motor| {
        let own = most(model.turns(model.motor(motor).joint));
        let of_motor = |one: &&Rolling<'_>| plan.sources[one.source] == Source::Motor(motor);
        let of_motor = rolling.iter().filter(of_motor);
        of_motor.fold(own, |least, one| {
            let (gain, most) = (float_of(one.part).abs(), most(one.turns));
            if gain * least > most { most / gain } else { least }
        })
    });
    let params = model.params.ids().map(|param| {
        let scale = model.param_scale(param);
        scale.map_or(1.0, |scale| PART * scale)
    });
    motors.chain(params).collect()
}

/// Something that rolling moves.
struct Rolling<'p> {
    /// The number of the source that moves it.
    source: usize,
    /// The part of the source's motion by which it moves.
    part: &'p Rational,
    /// Whether it turns; else it slides.
    turns: bool,
}

/// All that rolling moves in a step.
fn rolling(step: &Step) -> Vec<Rolling<'_>> {
    match step {
        Step::Mesh(mesh) => {
            let turns = mesh.connection.kind == ConnectionKind::Revolute;
            rolling_by(&mesh.parts, turns).collect()
        }
        Step::Close(closing) => {
            let ties = closing.ties.iter();
            ties.flat_map(|tie| rolling_by(&tie.sources, matches!(tie.of, Unknown::Direction(_))))
                .collect()
        }
        Step::Weld(_) | Step::Drive(_) | Step::Cam(_) => Vec::new(),
    }
}

/// All that moves by these parts of sources.
fn rolling_by(parts: &[(usize, Rational)], turns: bool) -> impl Iterator<Item = Rolling<'_>> {
    parts.iter().map(move |(source, part)| Rolling { source: *source, part, turns })
}
