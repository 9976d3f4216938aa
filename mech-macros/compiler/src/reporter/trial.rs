//! Repairs that are tried out before they are offered.

use crate::model::{JointId, LinkId, Model};
use crate::plan;
use crate::structure::{self, Diagnosis};

/// What becomes of a mechanism that was changed to see whether that would mend it.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Trial {
    /// It compiles, or would with a `near`.
    Closes,
    /// It would compile if it started elsewhere.
    OpensAtStart,
    /// It does not compile.
    Fails,
}

pub(super) fn trial(model: &Model) -> Trial {
    let outcome = structure::analyse(model)
        .map_err(|diagnoses| diagnoses.into_iter().next())
        .and_then(|structure| plan::plan(model, &structure).map_err(Some));
    match outcome {
        Ok(_) | Err(Some(Diagnosis::SeveralAssemblies { .. })) => Trial::Closes,
        Err(Some(Diagnosis::CannotClose { .. } | Diagnosis::DeadStart { .. })) => {
            Trial::OpensAtStart
        }
        Err(_) => Trial::Fails,
    }
}

/// The joints whose mechanism closes at once, and those whose mechanism would if it started elsewhere; those on the
/// ground first, because that is where motors like to sit.
pub(super) fn sorted(
    trials: impl Iterator<Item = (JointId, Model)>,
) -> (Vec<JointId>, Vec<JointId>) {
    let (mut at_once, mut elsewhere) = (Vec::new(), Vec::new());
    for (joint, model) in trials {
        let (a, b) = model.ends(joint);
        let aloft = a != LinkId::GROUND && b != LinkId::GROUND;
        match trial(&model) {
            Trial::Closes => at_once.push((aloft, joint)),
            Trial::OpensAtStart => elsewhere.push((aloft, joint)),
            Trial::Fails => {}
        }
    }
    let joints = |mut list: Vec<(bool, JointId)>| {
        list.sort_unstable();
        list.into_iter().map(|(_, joint)| joint).collect()
    };
    (joints(at_once), joints(elsewhere))
}
