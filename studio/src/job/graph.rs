//! Graphs of a mechanism.

use super::Analysed;
use mech_compiler::graphs;

/// The subject of a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum GraphKind {
    /// Links, and the joints between them.
    Links,
    /// Each loop, after the loops and motors that determine it.
    Loops,
    /// Loops that have joints in common.
    CommonJoints,
}

impl GraphKind {
    pub(super) fn dot(self, Analysed { model, compiled }: &Analysed) -> String {
        let graph = match self {
            Self::Links => graphs::kinematic(model, &compiled.structure),
            Self::Loops => graphs::loops(model, &compiled.plan),
            Self::CommonJoints => graphs::common_joints(model, &compiled.plan),
        };
        graph.to_dot()
    }
}
