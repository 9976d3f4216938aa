//! A loop that is being solved, and one that is.

use super::tied::Tied;
use crate::model::LinkId;
use crate::plan::{Equation, Loop, Solution};
use crate::program::choice::Choice;
use crate::program::node::{BlockId, Value};

/// A loop that is being lowered.
pub(super) struct LoopSite<'c> {
    /// Its number in the plan.
    pub(super) number: usize,
    pub(super) block: BlockId,
    pub(super) choice: Choice,
    /// Whether it is solved by iteration.
    pub(super) iterated: bool,
    pub(super) closing: &'c Loop,
    pub(super) equation: Equation<Value>,
    /// The base of its first cluster, from which its unknowns are seen.
    pub(super) base: LinkId,
    /// The joints whose coordinates are unknown, for messages.
    pub(super) place: String,
}

/// A loop that is solved.
pub(super) struct SolvedLoop {
    /// The number of its loop in the plan.
    pub(super) number: usize,
    /// The name of its block.
    pub(super) name: String,
    /// The joints of the loop whose coordinates are unknown, for messages.
    pub(super) place: String,
    pub(super) equation: Equation<Value>,
    /// Its directions and displacements, in the order of the equation's unknowns.
    pub(super) solution: Vec<Solution<Value>>,
    /// The relations of its directions and displacements to fewer unknowns, if rolling ties them.
    pub(super) tied: Option<Tied>,
}

impl SolvedLoop {
    /// Whether an angle is among its unknowns that is counted over whole turns.
    pub(super) fn counts_turns(&self) -> bool {
        self.tied.as_ref().is_some_and(Tied::counts_turns)
    }
}
