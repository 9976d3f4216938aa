//! Repairs: each is applied and the mechanism analysed again before it is offered.

use super::{Diagnosis, examine};
use crate::model::{JointId, Model};

/// Adds to each diagnosis that can have some the repairs that lead to a coherent mechanism.
pub(super) fn offer(model: &Model, diagnoses: &mut [Diagnosis]) {
    for diagnosis in diagnoses {
        match diagnosis {
            Diagnosis::Blocked { joints, cures, .. }
            | Diagnosis::Overdetermined { joints, cures } => {
                *cures = removable(model, joints);
            }
            Diagnosis::Rigid { cures } => {
                *cures = removable(model, &model.joint_ids().collect::<Vec<_>>());
            }
            _ => {}
        }
    }
}

fn removable(model: &Model, joints: &[JointId]) -> Vec<JointId> {
    joints
        .iter()
        .copied()
        .filter(|&joint| without(model, joint).is_some_and(|model| moves(&model)))
        .collect()
}

/// Whether the mechanism is coherent, or would be with motors in the right places.
fn moves(model: &Model) -> bool {
    match examine(model) {
        Ok(_) => true,
        Err(diagnoses) => matches!(diagnoses[..], [Diagnosis::NoMotor { .. }]),
    }
}

/// The mechanism without this joint; none if a motor sits on it.
fn without(model: &Model, joint: JointId) -> Option<Model> {
    if model.motor_of(joint).is_some() {
        return None;
    }
    let mut model = model.clone();
    let moved = |id: JointId| {
        if id > joint {
            JointId::new(id.index() - 1)
        } else {
            id
        }
    };
    model.joints.remove(joint.index());
    model
        .motors
        .iter_mut()
        .for_each(|motor| motor.joint = moved(motor.joint));
    model.start.values.retain(|value| value.joint != joint);
    model
        .start
        .values
        .iter_mut()
        .for_each(|value| value.joint = moved(value.joint));
    Some(model)
}
