//! Curves: what is measured while a motor moves through its range.

use super::snapshot::Snapshot;
use crate::failure::Failure;
use crate::job::Measure;
use crate::quantity::Table;
use std::sync::Arc;

pub(crate) struct Curves {
    /// The text, and what the compiler makes of it.
    pub(crate) snapshot: Arc<Snapshot>,
    pub(crate) wanted: Measure,
    /// The measured values, or why there are none.
    pub(crate) table: Result<Table, Failure>,
    /// Why some quantities cannot be measured.
    pub(crate) missing: Vec<Failure>,
}

impl Curves {
    /// Measures what is wanted of a mechanism. A quantity that an edit has removed does not take the others with it.
    pub(crate) fn of(snapshot: Arc<Snapshot>, wanted: Measure) -> Self {
        let mut missing = Vec::new();
        let table = match snapshot.moving() {
            Some((model, compiled)) => wanted.known_table(model, compiled, &mut missing),
            None => Err(Failure::mechanism("the mechanism does not move; see Diagnoses")),
        };
        Self { snapshot, wanted, table, missing }
    }
}
