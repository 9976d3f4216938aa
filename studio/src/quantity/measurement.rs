//! What is measured through a motion, and the table of it.

use super::Units;
use super::load::{self, Load};
use super::meter::Meter;
use super::needs::Needs;
use super::unit::Unit;
use crate::failure::Failure;
use crate::motion::Drive;
use mech_compiler::model::{Measurand, Measured, Model, Precision, Quantity};
use mech_compiler::{Compiled, compile};
use std::ops::Range;

/// A table of measurements: a row for each position.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Table {
    /// The name and the unit of each column. The first is what the mechanism is driven by.
    pub(crate) columns: Vec<(String, String)>,
    /// The values of each row, in these units; none where a value is not determined, as a velocity at a dead point.
    pub(crate) rows: Vec<Vec<Option<f64>>>,
    /// The number of the column over which the others are shown: the first, or the second.
    pub(crate) across: usize,
    pub(crate) precision: Precision,
}

impl Table {
    /// The numbers of the columns that are shown over that.
    pub(crate) fn curves(&self) -> Range<usize> {
        self.across + 1..self.columns.len()
    }

    /// Whether what has this unit is shown over the same unit, as the path of a point is: then both axes have one scale. Angles of links say
    /// nothing by their shape.
    pub(crate) fn is_path(&self, unit: &str) -> bool {
        self.across > 0 && self.columns[self.across].1 == unit && unit != "deg"
    }
}

/// A motion that is measured.
pub(crate) struct Measurement<'a> {
    pub(crate) model: &'a Model,
    pub(crate) drive: &'a Drive,
    /// Over what the others are shown, if not over what the mechanism is driven by.
    pub(crate) over: Option<Measurand>,
    /// The speed of its motor, in radians or scene units per second: without it, velocities are those at 1, and forces those at rest.
    pub(crate) rate: Option<f64>,
    /// The number of steps: there is a row more.
    pub(crate) steps: u32,
    /// The loads that are not zero.
    pub(crate) loads: &'a [Load],
    pub(crate) units: &'a Units,
}

/// Measures through a motion, in the precision of the mechanism.
pub(crate) fn measure(of: &Measurement<'_>, measurands: &[Measurand]) -> Result<Table, Failure> {
    let measurands: Vec<Measurand> = of.over.iter().chain(measurands).cloned().collect();
    let prepared = Prepared::new(of, &measurands)?;
    let parts = of.parts();
    let rows = of.drive.attempt(|drive| prepared.rows(drive, &parts))?;
    Ok(Table {
        columns: columns(of, &measurands),
        rows,
        across: usize::from(of.over.is_some()),
        precision: of.model.precision,
    })
}

impl Measurement<'_> {
    /// The parts of the motion at which it is measured, 0 to 1.
    pub(super) fn parts(&self) -> Vec<f64> {
        let parts = (0..=self.steps).map(|step| f64::from(step) / f64::from(self.steps.max(1)));
        parts.collect()
    }
}

/// A mechanism that is compiled for what is measured.
pub(super) struct Prepared<'a> {
    of: &'a Measurement<'a>,
    measurands: &'a [Measurand],
    model: Model,
    compiled: Compiled,
}

impl<'a> Prepared<'a> {
    pub(super) fn new(
        of: &'a Measurement<'a>,
        measurands: &'a [Measurand],
    ) -> Result<Self, Failure> {
        let mut measured = measurands.iter().flat_map(Measurand::own);
        let needs_rate = measured.find_map(|one| match one.quantity()? {
            Quantity::Power(_) => Some("a power needs"),
            Quantity::Shaking(_) => Some("what shakes the ground needs"),
            _ => None,
        });
        if let (None, Some(_), Some(needs)) = (of.rate, of.drive.motor(), needs_rate) {
            return Err(Failure::usage(format!(
                "{needs} the rate at which the motor moves: `--rate 1`"
            )));
        }
        let model = Needs::of(measurands).added_to(of.model);
        Ok(Self { compiled: compiled_for(&model)?, of, measurands, model })
    }

    /// What drives it and all measurands in these parts of a motion, a row for each.
    pub(super) fn rows(
        &self,
        drive: &Drive,
        parts: &[f64],
    ) -> Result<Vec<Vec<Option<f64>>>, Failure> {
        let Self { of, measurands, model, compiled } = self;
        let loads = load::numbers(model, of.loads)?;
        let mut meter = Meter::new(model, compiled, measurands, loads)?;
        let mut rows = vec![Vec::new(); parts.len()];
        let units = measurands.iter().map(|one| Unit::of(model, one));
        let units: Vec<Unit> = units.collect();
        let driver = driver(of);
        drive.visit(model, compiled, parts, |number, at| {
            // Forces are those at rest, if nobody says a rate.
            let rates = [1.0, 0.0].map(|usual| of.rate.unwrap_or(usual));
            let moments = drive.moments(model, compiled, parts[number], rates);
            let [moment, _] = &moments;
            let values = meter.read(at, moments.each_ref(), measurands)?;
            let shown = units.iter().zip(values);
            let shown = shown.map(|(unit, value)| value.map(|value| unit.shown(value)));
            rows[number] = std::iter::once(Some(driver.shown(moment.by))).chain(shown).collect();
            Ok(())
        })?;
        Ok(rows)
    }
}

/// The unit of what drives the mechanism.
fn driver(of: &Measurement<'_>) -> Unit {
    match of.drive.motor() {
        Some(motor) => Unit::of_coordinate(of.model, of.model.motor(motor).joint),
        None => Unit::TIME,
    }
}

pub(super) fn columns(of: &Measurement<'_>, measurands: &[Measurand]) -> Vec<(String, String)> {
    let name = match of.drive.motor() {
        Some(motor) => {
            let joint = of.model.motor(motor).joint;
            format!("motor {}", of.model.joint(joint).name)
        }
        None => "t".to_owned(),
    };
    let others = measurands.iter().map(|measurand| {
        let name = format!("{}{}", measurand.name, assumed(of, measurand));
        (name, of.units.name(Unit::of(of.model, measurand)))
    });
    std::iter::once((name, of.units.name(driver(of)))).chain(others).collect()
}

/// The rate of the motor for which a force holds, as words after its name.
fn assumed(of: &Measurement<'_>, measurand: &Measurand) -> String {
    let mut quantities = measurand.own().filter_map(Measured::quantity);
    let rate = of.rate.unwrap_or(0.0);
    if of.drive.motor().is_none() || !quantities.any(Quantity::is_force) {
        String::new()
    } else if rate == 0.0 {
        " at rest".to_owned()
    } else {
        format!(" at rate {rate}")
    }
}

/// A mechanism with the effects that it declares, compiled; what is wrong with it is told.
pub(crate) fn compiled(model: &Model) -> Result<Compiled, Failure> {
    compile(model).map_err(|diagnoses| {
        let texts =
            diagnoses.iter().map(|diagnosis| mech_compiler::reporter::text(diagnosis, model));
        let texts: Vec<String> = texts.collect();
        Failure::mechanism(format!("that cannot be computed: {}", texts.join("\n")))
    })
}

/// The mechanism, compiled: where equilibrium does not determine the forces within it, with what virtual work tells of the motors.
pub(super) fn compiled_for(model: &Model) -> Result<Compiled, Failure> {
    let compiled = compiled(model)?;
    let forced = &compiled.forced;
    if !model.effects.force || forced.inverse_dynamics.is_some() || forced.inertia.is_some() {
        return Ok(compiled);
    }
    let mut moved = model.clone();
    moved.effects.dynamics = true;
    compiled_for(&moved)
}
