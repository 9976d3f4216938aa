//! Whether a motor turns right round.

use super::Proof;
use super::Verdicts;
use super::round_of;
use crate::certify::{Interval, Verdict};
use crate::compiled::Compiled;
use crate::model::{Model, MotorId};
use crate::motion::proof::unknowns;
use crate::program::Value;
use crate::structure::RequirementTrouble;

/// Proves that a motor turns right round, while all others stand at their start.
pub(super) fn prove(
    model: &Model,
    compiled: &Compiled,
    verdicts: &Verdicts<'_>,
    motor: MotorId,
) -> Result<Proof, RequirementTrouble> {
    let program = &compiled.program;
    let number = motor.index();
    let start = program.start.motors[number];
    if let Some(range) = model.motor(motor).range
        && range.high - range.low < std::f64::consts::TAU.next_down()
    {
        return Err(RequirementTrouble::Limited { motor });
    }
    let discriminants: Vec<Value> =
        program.margins().map(|(_, closed)| closed.discriminant).collect();
    let loops = compiled.plan.loops().count();
    let Some(period) = round_of(model, program, (loops, number), &discriminants) else {
        return Err(RequirementTrouble::NoRange { motor });
    };
    for way in [0.5 * period, -0.5 * period] {
        let mut ranges = Interval::points(&program.start.motors);
        ranges[number] = Interval::new(start, start + way);
        match verdicts.on(&ranges) {
            Verdict::Proved { .. } => {}
            Verdict::Blocked(blocked) => {
                return Err(RequirementTrouble::Stops {
                    motor,
                    limit: blocked.limit,
                    unknowns: unknowns(&compiled.plan, program, blocked.block),
                });
            }
            Verdict::NoClosedForm { block } => {
                let unknowns = unknowns(&compiled.plan, program, block);
                return Err(RequirementTrouble::Iterated { unknowns });
            }
            Verdict::Undecided { .. } => return Err(RequirementTrouble::TooHard),
        }
    }
    Ok(Proof { effort: 0 })
}
