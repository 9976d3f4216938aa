//! The facts about the range of a program's inputs and numbers.

use crate::model::{Joint, JointKind, Model};
use crate::plan::{Plan, Rational, Step};
use num_traits::Signed;

/// For each motor and param, whether its value is read less whole turns, and the turns apart from it. It is so where gears turn by a part
/// of it, and the model asks for an accuracy.
pub(super) fn reduced_inputs(model: &Model, plan: &Plan) -> Vec<bool> {
    let asked = model.accuracy.is_some() || model.motors.iter().any(|motor| motor.step.is_some());
    let meshes = plan
        .steps
        .iter()
        .any(|step| matches!(step, Step::Mesh(_) | Step::Cam(_)) || ties_sources(step));
    let turning = model.motors.iter().map(|motor| {
        let turns = model.turns(motor.joint);
        asked && meshes && turns
    });
    let fixed = model.params.ids().map(|_| false);
    turning.chain(fixed).collect()
}

/// Whether a step closes a loop whose directions follow motors by rolling.
fn ties_sources(step: &Step) -> bool {
    matches!(step, Step::Close(closing) if closing.ties.iter().any(|tie| !tie.sources.is_empty()))
}

/// Whether something may move beyond the range of the numbers: what slides may, if a motor or a rack drives it; what a law drives
/// that may have no value; what is as long as a param; and what turns farther than what drives it, or by several things.
pub(super) fn overflows(model: &Model, plan: &Plan) -> bool {
    let multiplies = |step: &Step| {
        let Step::Mesh(mesh) = step else {
            return false;
        };
        let one = Rational::from_integer(1.into());
        mesh.parts.len() > 1 || mesh.parts.iter().any(|(_, part)| part.abs() > one)
    };
    let slides = |joint: &Joint| {
        matches!(
            joint.kind,
            JointKind::Prismatic(..) | JointKind::Rack { .. } | JointKind::Cam { .. }
        )
    };
    model.joints.iter().any(slides) || !model.params.is_empty() || plan.steps.iter().any(multiplies)
}
