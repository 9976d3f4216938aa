//! Structure: what is connected, what moves, what is blocked or left undetermined, what is trunk and what is arm.

mod carrier;
mod constraints;
mod diagnosis;
mod elimination;
mod field;
mod graph;
mod parallel;
mod pin;
mod rolling;
mod still;
mod verdict;
mod welded;

pub use diagnosis::{
    Diagnosis, Extreme, InverseTrouble, LoopAssembly, MeshTrouble, OpenLoop, RangeTrouble,
    RequirementTrouble, TrajectoryStop, Witness, WitnessPlace,
};
pub(crate) use graph::KinematicGraph;
pub use parallel::Parallels;
pub use pin::Pin;
pub use rolling::{Factor, Rolling, RollingEnd};
pub use still::StillPin;
pub(crate) use still::still_pins;
pub use welded::Welded;

use crate::bug::bug;
use crate::model::{AxisId, Joint, JointId, JointKind, LinkId, Model};

/// The structure of a coherent mechanism.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Structure {
    /// The mobility by the count `3N − 2(R + P) − G`.
    pub mobility: i64,
    /// The joints that belong to a loop.
    pub trunk: Vec<JointId>,
    /// The joints that belong to none: those of the open chains.
    pub arms: Vec<JointId>,
    /// The joints that hold a part more than once, where that is allowed.
    pub redundant: Vec<JointId>,
    /// The links that are one body.
    pub welded: Welded,
    /// The axes of rotation, with all links on each.
    pub pins: Vec<Pin>,
    /// The gears, belts and racks, with their carriers.
    pub rollings: Vec<Rolling>,
    /// The slides that stay parallel.
    pub parallels: Parallels,
    /// The pins that do not turn in their slots, where joints may hold more than once.
    pub still: Vec<StillPin>,
}

impl Structure {
    /// The axes about which a wheel turns on its carrier, one on each. Where one of them has no axis there, the axis of a link that is
    /// welded to it.
    #[must_use]
    pub fn hub(&self, wheel: LinkId, carrier: LinkId) -> Option<[AxisId; 2]> {
        pin::hub(&self.pins, &self.welded, wheel, carrier)
    }

    /// The pin on which a wheel turns on its carrier, or what is welded to them.
    pub(crate) fn shaft(&self, wheel: LinkId, carrier: LinkId) -> Option<&Pin> {
        pin::shaft(&self.pins, &self.welded, wheel, carrier)
    }
}

/// Analyses a mechanism.
///
/// # Errors
/// Everything that keeps it from moving as its motors say.
pub fn analyse(model: &Model) -> Result<Structure, Vec<Diagnosis>> {
    let structure = layout(model)?;
    verdict::verdict(model, &structure)?;
    Ok(structure)
}

/// Whether [`analyse`] would find nothing wrong: counted without finding out why.
pub(crate) fn is_sound(model: &Model) -> bool {
    layout(model).is_ok_and(|structure| verdict::is_sound(model, &structure))
}

/// All pins of a mechanism, in the order of their first joint.
pub(crate) fn pins(model: &Model) -> Vec<Pin> {
    pin::pins(model, &Welded::new(model))
}

/// The links that could carry a gear, belt or rack.
pub(crate) fn carriers(model: &Model, joint: JointId) -> Vec<LinkId> {
    let welded = Welded::new(model);
    carrier::carriers(model, (&pin::pins(model, &welded), &welded), joint)
}

/// Finds out what is connected to what, without asking whether it moves.
pub(crate) fn layout(model: &Model) -> Result<Structure, Vec<Diagnosis>> {
    let graph = KinematicGraph::new(model);
    check_connected(&graph, model)?;
    let welded = Welded::new(model);
    let pins = pin::pins(model, &welded);
    let rollings = carrier::rollings(model, (&pins, &welded))?;
    let arms = graph.arms();
    let trunk = model.joint_ids().filter(|joint| !arms.contains(joint)).collect();
    Ok(Structure {
        mobility: mobility(model),
        trunk,
        arms,
        redundant: Vec::new(),
        welded,
        pins,
        rollings,
        parallels: parallel::parallels(model),
        still: Vec::new(),
    })
}

fn check_connected(graph: &KinematicGraph, model: &Model) -> Result<(), Vec<Diagnosis>> {
    let pieces = graph.pieces_off_ground();
    let jointless = |link| {
        model.joint_ids().all(|joint| model.ends(joint).0 != link && model.ends(joint).1 != link)
    };
    let diagnosis = |links: Vec<_>| match links[..] {
        [link] if jointless(link) => Diagnosis::Loose { link },
        _ => Diagnosis::Disconnected { links },
    };
    if pieces.is_empty() { Ok(()) } else { Err(pieces.into_iter().map(diagnosis).collect()) }
}

/// Mobility by counting: each moving link has three freedoms, each joint takes some away.
#[must_use]
pub fn mobility(model: &Model) -> i64 {
    let taken = |joint: &Joint| match joint.kind {
        JointKind::Weld(..) => 3,
        JointKind::Revolute(..) | JointKind::Prismatic(..) => 2,
        JointKind::Gear { .. }
        | JointKind::Belt { .. }
        | JointKind::Rack { .. }
        | JointKind::Cam { .. } => 1,
    };
    let taken: usize = model.joints.iter().map(taken).sum();
    let given = 3 * (model.links.len() - 1);
    let [given, taken] = [given, taken]
        .map(|count| i64::try_from(count).unwrap_or_else(|_| bug!("{count} freedoms are counted")));
    given - taken
}
