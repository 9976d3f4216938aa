//! Joints that may hold another link than is written.

use super::Repair;
use super::trial::Trials;
use crate::model::{JointId, LinkId, Model};
use crate::structure::Diagnosis;

/// The changes of one end of a joint after which nothing is wrong: of those first that a diagnosis names. What was declared last is the
/// likelier slip.
pub(super) fn attachments(trials: &mut Trials<'_>, diagnoses: &[Diagnosis]) -> Vec<Repair> {
    let model = trials.model;
    let mut joints: Vec<JointId> = model.declared_joints().collect();
    joints.retain(|joint| model.joint(*joint).kind.axes().is_some());
    joints.sort_by_key(|joint| {
        let is_told = diagnoses.iter().any(|one| is_told(one, *joint));
        (!is_told, std::cmp::Reverse(*joint))
    });
    let links = || [LinkId::GROUND].into_iter().chain(model.declared_links());
    let changes = joints.into_iter().flat_map(|joint| {
        let ends = ends(model, joint);
        let changes = ends.into_iter().flat_map(move |from| {
            let others = links().filter(move |to| !ends.contains(to));
            others.map(move |to| Repair::Attach { joint, from, to })
        });
        changes.collect::<Vec<_>>()
    });
    trials.first_that_mend(changes)
}

/// Whether a diagnosis is about a joint.
fn is_told(diagnosis: &Diagnosis, joint: JointId) -> bool {
    match diagnosis {
        Diagnosis::Blocked { joints, .. }
        | Diagnosis::Overdetermined { joints, .. }
        | Diagnosis::OnOnePin { joints, .. } => joints.contains(&joint),
        Diagnosis::Undetermined { free, .. } => free.contains(&joint),
        _ => false,
    }
}

/// The two links that a joint holds, as they are written: instead of a die, that of its pin.
fn ends(model: &Model, joint: JointId) -> [LinkId; 2] {
    let (a, b) = model.ends(joint);
    [a, b].map(|link| match model.link(link).die {
        Some((pin, _)) => model.axis(pin).link,
        None => link,
    })
}
