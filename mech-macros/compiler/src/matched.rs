//! Mechanisms that counting condemns and that move all the same, because their lengths match exactly: parallelograms with a
//! crank too many. Tested by moving.

use crate::evaluate::{self, Machine};
use crate::model::{Allowances, JointId, Model, MotorId};
use crate::plan::{self, Loop, Plan};
use crate::program::{self, Program};
use crate::structure::{self, Structure};

/// How far each motor is moved, in radians, or as a part of the mechanism's size: far enough for a link that only touches its
/// circle to leave it, by any order of contact that occurs.
const NUDGE: f64 = 0.02;

/// A mechanism that moves because its lengths match.
pub(crate) struct Matched {
    pub(crate) structure: Structure,
    pub(crate) plan: Plan,
    pub(crate) program: Program,
}

/// Tries to assemble and to move a mechanism whose joints hold each other more than once.
pub(crate) fn matched(model: &Model) -> Option<Matched> {
    let lenient = Model {
        allow: Allowances {
            redundant: true,
            ..model.allow
        },
        ..model.clone()
    };
    let mut structure = structure::layout(&lenient).ok()?;
    let plan = plan::plan(&lenient, &structure).ok()?;
    let mut program = program::build(&lenient, &plan);
    evaluate::settle(&mut program).ok()?;
    let moves = |motor: MotorId| {
        [NUDGE, -NUDGE]
            .into_iter()
            .any(|way| nudged(&lenient, &program, motor, way))
    };
    if model.motors.is_empty() || !model.motor_ids().all(moves) {
        return None;
    }
    structure.redundant = too_many(&plan);
    Some(Matched {
        structure,
        plan,
        program,
    })
}

fn nudged(model: &Model, program: &Program, motor: MotorId, way: f64) -> bool {
    let mut machine = Machine::<f64>::new(program);
    let mut motors = machine.position().motors.clone();
    let slides = matches!(
        model.joint(model.motor(motor).joint).kind,
        crate::model::JointKind::Prismatic(..)
    );
    let size = model
        .axes
        .iter()
        .fold(0.0_f64, |size, axis| size.max(axis.at[0].hypot(axis.at[1])));
    motors[motor.index()] += if slides { way * size } else { way };
    machine.move_to(&motors).is_ok()
}

/// The joints that were not needed to find where everything is.
fn too_many(plan: &Plan) -> Vec<JointId> {
    plan.loops()
        .filter(|closing| closing.is_redundant())
        .flat_map(Loop::unknowns)
        .collect()
}
