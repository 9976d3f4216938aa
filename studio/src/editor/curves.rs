//! Curves: what is measured while a motor moves through its range.

use super::snapshot::Snapshot;
use crate::failure::Failure;
use crate::job::Measure;
use crate::motion::{Drive, Setting, Span};
use crate::quantity::{self, Load, Measurement, Table, Units};
use std::sync::Arc;

/// The quantities to measure, and the motion in which they are measured.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Wanted {
    /// The quantities, as `mech table` calls them.
    pub(crate) names: Vec<String>,
    /// Over what they are shown, if not over the motor.
    pub(crate) over: Option<String>,
    /// The motor that moves; none for the laws of all.
    pub(crate) motor: Option<String>,
    /// Where the other motors stand, in degrees or scene units.
    pub(crate) others: Vec<(String, f64)>,
    /// The loads that are not zero.
    pub(crate) loads: Vec<Load>,
}

pub(crate) struct Curves {
    /// The text, and what the compiler makes of it.
    pub(crate) snapshot: Arc<Snapshot>,
    pub(crate) wanted: Wanted,
    /// The measured values, or why there are none.
    pub(crate) table: Result<Table, Failure>,
    /// Why some quantities cannot be measured.
    pub(crate) missing: Vec<Failure>,
}

impl Curves {
    /// Measures what is wanted of a mechanism.
    pub(crate) fn of(snapshot: Arc<Snapshot>, wanted: Wanted) -> Self {
        let mut missing = Vec::new();
        let table = measured(&snapshot, &wanted, &mut missing);
        Self {
            snapshot,
            wanted,
            table,
            missing,
        }
    }
}

fn measured(
    snapshot: &Snapshot,
    wanted: &Wanted,
    missing: &mut Vec<Failure>,
) -> Result<Table, Failure> {
    let (Some(reading), Some(compiled)) = (&snapshot.reading, snapshot.compiled()) else {
        return Err(Failure::mechanism(
            "the mechanism does not move; see Diagnoses",
        ));
    };
    let model = &reading.model;
    let dyads = quantity::dyads(model, &compiled.plan);
    let mut quantities = Vec::new();
    for name in &wanted.names {
        match quantity::quantities(model, &dyads, name) {
            Ok(found) => quantities.extend(found),
            // A quantity that an edit has removed does not take the others with it.
            Err(failure) => missing.push(failure),
        }
    }
    let over = wanted.over.as_deref();
    let over = over.and_then(|name| {
        let found = quantity::only_quantity(model, &dyads, name);
        found.map_err(|failure| missing.push(failure)).ok()
    });
    let settings = wanted.others.iter().cloned().map(Setting::from);
    let settings: Vec<Setting> = settings.collect();
    let motor = wanted.motor.as_deref();
    let drive = Drive::new(model, compiled, motor, Span::default(), &settings)?;
    let measurement = Measurement {
        model,
        drive: &drive,
        over,
        rate: None,
        steps: Measure::STEPS,
        loads: &wanted.loads,
        units: &Units::default(),
    };
    quantity::measure(&measurement, &quantities)
}
