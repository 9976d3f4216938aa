//! How far motors may go in one piece where nothing else tells it: loops that are solved together could leap over a place where they do
//! not close.

use crate::model::{JointKind, Model, MotorId};
use crate::plan::{ConnectionKind, Plan, Rational, Source, Step, Unknown, float_of};

/// Nothing that motors turn may turn farther in one piece, in radians.
const TURN: f64 = 0.25;
/// Nothing may slide farther, nor a length change more, as a part of its size.
const PART: f64 = 0.02;

/// For each motor and param so short a way that loops which close at both ends are not likely to be open between. Where loops are
/// coupled, nothing that a motor drives by rolling goes farther either.
pub(super) fn max_steps(model: &Model, plan: &Plan, is_coupled: bool) -> Vec<f64> {
    let most = Most {
        turn: TURN,
        slide: PART * model.size().max(f64::MIN_POSITIVE),
    };
    let steps = if is_coupled { &plan.steps[..] } else { &[] };
    let rolling: Vec<Rolling<'_>> = steps.iter().flat_map(|step| most.rolling(step)).collect();
    let motors = model.motor_ids().map(|motor| {
        let of_motor = |one: &&Rolling<'_>| plan.sources[one.source] == Source::Motor(motor);
        let of_motor = rolling.iter().filter(of_motor);
        of_motor.fold(most.own(model, motor), |least, one| {
            let gain = float_of(one.part).abs();
            if gain * least > one.most {
                one.most / gain
            } else {
                least
            }
        })
    });
    let params = model.params.ids().map(|param| {
        let scale = model.param_scale(param);
        scale.map_or(1.0, |scale| PART * scale)
    });
    motors.chain(params).collect()
}

/// How far something may move in one piece.
struct Most {
    turn: f64,
    slide: f64,
}

impl Most {
    /// How far a motor may go itself.
    fn own(&self, model: &Model, motor: MotorId) -> f64 {
        match model.joint(model.motor(motor).joint).kind {
            JointKind::Revolute(..) => self.turn,
            _ => self.slide,
        }
    }

    /// What rolling moves in a step.
    fn rolling<'p>(&self, step: &'p Step) -> Vec<Rolling<'p>> {
        match step {
            Step::Mesh(mesh) => {
                let most = match mesh.connection.kind {
                    ConnectionKind::Revolute => self.turn,
                    ConnectionKind::Prismatic => self.slide,
                };
                rolling_by(&mesh.parts, most).collect()
            }
            Step::Close(closing) => {
                let ties = closing.ties.iter();
                ties.flat_map(|tie| match tie.of {
                    Unknown::Direction(_) => rolling_by(&tie.sources, self.turn),
                    Unknown::Slide(_) => rolling_by(&tie.sources, self.slide),
                })
                .collect()
            }
            Step::Weld(_) | Step::Drive(_) | Step::Cam(_) => Vec::new(),
        }
    }
}

/// What is moved by rolling.
struct Rolling<'p> {
    /// The number of the source that moves it.
    source: usize,
    /// The part of the source's motion by which it moves.
    part: &'p Rational,
    /// How far it may move in one piece.
    most: f64,
}

/// What moves by these parts of what sources move.
fn rolling_by(parts: &[(usize, Rational)], most: f64) -> impl Iterator<Item = Rolling<'_>> {
    parts.iter().map(move |(source, part)| Rolling {
        source: *source,
        part,
        most,
    })
}
