//! Structure: what is connected, what moves, what is blocked or left undetermined, what is trunk and what is arm.

mod constraints;
mod cure;
mod diagnosis;
mod elimination;
mod field;
mod gear;
mod graph;
mod pin;
mod verdict;

pub use diagnosis::Diagnosis;
pub use gear::Gear;
pub(crate) use graph::KinematicGraph;
pub use pin::Pin;

use crate::model::{JointId, JointKind, Model};

/// What was found out about a coherent mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct Structure {
    /// The mobility by the count `3N − 2(R + P) − G`.
    pub mobility: i64,
    /// The joints that belong to a loop.
    pub trunk: Vec<JointId>,
    /// The joints that belong to none: those of the open chains.
    pub arms: Vec<JointId>,
    /// The axes of rotation, with all links on each.
    pub pins: Vec<Pin>,
    /// The gears, with their carriers.
    pub gears: Vec<Gear>,
}

/// Analyses a mechanism.
///
/// # Errors
/// Everything that keeps it from moving as its motors say, each with the repairs that were tried and found to help.
pub fn analyse(model: &Model) -> Result<Structure, Vec<Diagnosis>> {
    let mut diagnoses = match examine(model) {
        Ok(structure) => return Ok(structure),
        Err(diagnoses) => diagnoses,
    };
    cure::offer(model, &mut diagnoses);
    Err(diagnoses)
}

/// Analyses a mechanism without looking for repairs.
fn examine(model: &Model) -> Result<Structure, Vec<Diagnosis>> {
    let graph = KinematicGraph::new(model);
    connected(&graph, model)?;
    let pins = pin::pins(model);
    let gears = gear::gears(model, &pins)?;
    verdict::verdict(model, &pins, &gears)?;
    let arms = graph.arms();
    let trunk = model
        .joint_ids()
        .filter(|joint| !arms.contains(joint))
        .collect();
    Ok(Structure {
        mobility: mobility(model),
        trunk,
        arms,
        pins,
        gears,
    })
}

fn connected(graph: &KinematicGraph, model: &Model) -> Result<(), Vec<Diagnosis>> {
    let pieces = graph.pieces_off_ground();
    let jointless = |link| {
        model
            .joint_ids()
            .all(|joint| model.ends(joint).0 != link && model.ends(joint).1 != link)
    };
    let diagnosis = |links: Vec<_>| match links[..] {
        [link] if jointless(link) => Diagnosis::Loose { link },
        _ => Diagnosis::Disconnected { links },
    };
    if pieces.is_empty() {
        Ok(())
    } else {
        Err(pieces.into_iter().map(diagnosis).collect())
    }
}

/// Mobility by counting: each moving link has three freedoms, each joint takes some away.
#[must_use]
pub fn mobility(model: &Model) -> i64 {
    let taken: usize = model
        .joints
        .iter()
        .map(|joint| {
            if let JointKind::Gear { .. } = joint.kind {
                1
            } else {
                2
            }
        })
        .sum();
    let given = 3 * (model.links.len() - 1);
    i64::try_from(given).unwrap_or(i64::MAX) - i64::try_from(taken).unwrap_or(i64::MAX)
}
