//! What is plotted: what the user wants to see, and what was measured last.

use super::curves::{Curves, Wanted};
use super::snapshot::Snapshot;
use crate::quantity::Load;
use mech_compiler::model::LoadKind;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What is plotted.
#[derive(Default)]
pub(super) struct Plotted {
    /// The quantities, as `mech plot` calls them.
    pub(super) names: Vec<String>,
    /// The quantity over which they are shown, if not over the motor.
    pub(super) over: Option<String>,
    /// The motor that moves through its range; without, the first.
    pub(super) motor: Option<String>,
    /// What is typed of the loads, by their names.
    pub(super) loads: BTreeMap<String, String>,
    /// What is being measured.
    pub(super) asked: Option<(Arc<Snapshot>, Wanted)>,
    /// What was measured last.
    pub(super) curves: Option<Curves>,
}

/// What is typed of a load: its numbers, or nothing for zero.
pub(super) fn read_load(name: &str, kind: LoadKind, typed: &str) -> Result<Option<Load>, String> {
    if typed.trim().is_empty() {
        return Ok(None);
    }
    let count = typed.split(',').count();
    match (kind, count) {
        (LoadKind::Force(_), 2) | (LoadKind::Torque(_), 1) => {
            format!("{name}={typed}").parse().map(Some)
        }
        (LoadKind::Force(_), _) => Err("a force has two parts: `x, y`".to_owned()),
        (LoadKind::Torque(_), _) => Err("a torque is one number".to_owned()),
    }
}
