//! The report's lines about loops and their methods.

use super::{joints, plural};
use crate::model::{JointId, Method, Model};
use crate::motion::accuracy::{Prediction, SolvedLoop};
use crate::plan::{ConnectionKind, Loop, Plan, Step};
use crate::program::{self, Program};

/// The level and the unknowns of a loop.
pub(super) fn loop_line(model: &Model, closing: &Loop) -> String {
    let unknowns = closing.connections().map(|connection| {
        let kind = match connection.kind {
            ConnectionKind::Revolute => "angle",
            ConnectionKind::Prismatic => "displacement",
        };
        format!("{} ({kind})", model.joint(connection.joint).name)
    });
    let unknowns: Vec<String> = unknowns.collect();
    let coupled = if closing.is_coupled() {
        format!("{} rings together, ", closing.rings.len())
    } else {
        String::new()
    };
    let tied = match closing.ties.len() {
        0 => String::new(),
        ties => format!(", {ties} tied by rolling"),
    };
    format!("level {}: {coupled}unknowns {}{tied}", closing.level, unknowns.join(", "))
}

/// The joints of a loop, and the loops or motors that determine it.
pub(super) fn needs_line(model: &Model, plan: &Plan, closing: &Loop) -> String {
    let needs = closing.needs.iter().map(|need| (need + 1).to_string());
    let needs: Vec<String> = needs.collect();
    let needs = match plural("after loop", needs.len(), &needs.join(", ")) {
        Some(needs) => needs,
        None => drivers(model, plan, closing),
    };
    format!("joints {}; {needs}", joints(model, &closing.members))
}

/// The motors, gears and cams among the joints of a loop that needs no other.
fn drivers(model: &Model, plan: &Plan, closing: &Loop) -> String {
    let driven = plan.steps.iter().filter_map(|step| match step {
        Step::Drive(drive) => Some((drive.connection.joint, "motor", drive.connection.joint)),
        Step::Mesh(mesh) => Some((mesh.connection.joint, "rolling", mesh.by)),
        Step::Cam(cam) => Some((cam.connection.joint, "cam", cam.by)),
        Step::Weld(_) | Step::Close(_) => None,
    });
    let mut words: Vec<String> = driven
        .filter(|(joint, ..)| closing.members.contains(joint))
        .map(|(_, kind, by)| format!("{kind} {}", model.joint(by).name))
        .collect();
    words.dedup();
    if words.is_empty() {
        "rigid by itself".to_owned()
    } else {
        format!("driven by {}", words.join(", "))
    }
}

/// The method of a loop, its estimated error and its cost.
pub(super) fn method_line(solved: &SolvedLoop) -> String {
    let error = match solved.error {
        None => String::new(),
        Some(error) if error.is_finite() => format!(", estimated error {error:.1e}"),
        Some(_) => ", may stop for no reason but its method".to_owned(),
    };
    format!("{}{error}: {}", solved.method, solved.cost)
}

/// The method of all loops, as declared.
pub(super) fn method(model: &Model, program: &Program) -> String {
    match (model.method, model.accuracy) {
        _ if !program.has_loops() => "none needed".to_owned(),
        (None, Some(_)) => "the cheapest that is accurate enough".to_owned(),
        (None | Some(Method::Exact), _) => "exact".to_owned(),
        (Some(Method::Newton), _) => "Newton, until each loop closes to rounding".to_owned(),
        (Some(Method::Linear), _) => "linear".to_owned(),
        (Some(Method::NewtonSteps(1)), _) => "Newton, one round a loop".to_owned(),
        (Some(Method::NewtonSteps(rounds)), _) => format!("Newton, {rounds} rounds a loop"),
    }
}

/// The estimated error and the declared accuracy, in scene units.
pub(super) fn accuracy(model: &Model, prediction: &Prediction) -> String {
    let error = match prediction.error {
        error if error.is_finite() => format!("{error:.1e} estimated"),
        _ => "not estimated: it may stop for no reason but its method".to_owned(),
    };
    match model.accuracy {
        Some(accuracy) => format!("{error}, {accuracy:e} wanted"),
        None => error,
    }
}

/// The loops and joints that are not computed, because nothing that is shown depends on them.
pub(super) fn omissions(model: &Model, plan: &Plan, program: &Program) -> String {
    let solved = program.solved_loops();
    let needed = program::find_needed(model, plan, &program.stored);
    let idle = (0..plan.loops().count()).filter(|number| !solved.contains(number));
    let loops: Vec<String> = idle.map(|number| (number + 1).to_string()).collect();
    let idle_arms = plan.steps.iter().zip(&needed.steps);
    let idle_arms = idle_arms.filter(|(step, needed)| !**needed && !matches!(step, Step::Close(_)));
    let mut arms: Vec<JointId> = idle_arms
        .flat_map(|(step, _)| step.connections())
        .map(|connection| connection.joint)
        .collect();
    arms.sort_unstable();
    let mut parts = Vec::new();
    parts.extend(plural("loop", loops.len(), &loops.join(", ")));
    parts.extend(plural("joint", arms.len(), &joints(model, &arms)));
    if parts.is_empty() {
        parts.push("poses".to_owned());
    }
    parts.join(" and ")
}
