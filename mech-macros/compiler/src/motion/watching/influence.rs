//! Which motors have a part in whether a loop closes.
//!
//! A loop closes or not by the coordinates of its own joints. Where its links are carried about as a whole, as the bucket of an
//! excavator is by its boom, what carries them has no part in it.

use crate::model::JointId;
use crate::plan::{Loop, Plan, Source, Step};
use std::collections::{BTreeMap, BTreeSet};

/// The numbers of motors, or none if any motor may have a part.
pub(super) type Motors = Option<BTreeSet<usize>>;

/// For each loop of a plan the motors that have a part in whether it closes. Params are not looked at.
pub(super) fn motors_of_loops(plan: &Plan) -> Vec<Motors> {
    let mut of_joints = BTreeMap::new();
    let mut of_loops = Vec::new();
    for step in &plan.steps {
        let (joint, motors) = match step {
            Step::Weld(weld) => (weld.joint, Some(BTreeSet::new())),
            Step::Drive(drive) => (
                drive.connection.joint,
                Some(BTreeSet::from([drive.motor.index()])),
            ),
            Step::Mesh(mesh) => (mesh.connection.joint, of_parts(plan, &mesh.parts)),
            Step::Cam(cam) => (cam.connection.joint, of_parts(plan, &cam.parts)),
            Step::Close(closing) => {
                let motors = of_loop(closing, &of_joints);
                let unknowns = closing.unknowns().into_iter();
                of_joints.extend(unknowns.map(|joint| (joint, motors.clone())));
                of_loops.push(motors);
                continue;
            }
        };
        of_joints.insert(joint, motors);
    }
    of_loops
}

/// Those that determine the coordinates of a loop's known joints.
fn of_loop(closing: &Loop, of_joints: &BTreeMap<JointId, Motors>) -> Motors {
    if !closing.ties.is_empty() {
        return None;
    }
    let unknowns = closing.unknowns();
    let known = closing
        .members
        .iter()
        .filter(|joint| !unknowns.contains(joint));
    known
        .map(|joint| of_joints.get(joint).cloned().flatten())
        .try_fold(BTreeSet::new(), |mut all, motors| {
            all.extend(motors?);
            Some(all)
        })
}

/// The motors among what rolling or a cam is solved from.
fn of_parts<Part>(plan: &Plan, parts: &[(usize, Part)]) -> Motors {
    let sources = parts.iter().map(|(source, _)| plan.sources[*source]);
    sources
        .map(|source| match source {
            Source::Motor(motor) => Some(motor.index()),
            Source::Angle { .. } | Source::Displacement(_) => None,
        })
        .collect()
}
