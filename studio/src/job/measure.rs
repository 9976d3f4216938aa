//! The measurement that tables and charts have in common: quantities and a motion.

use super::Analysed;
use crate::failure::Failure;
use crate::motion::{Drive, Goal, Setting, Span};
use crate::quantity::{self, Load, Measurement, Summary, Table, Units};
use mech_compiler::Compiled;
use mech_compiler::model::{Measurand, Model};

/// The quantities to measure, and the motion.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Measure {
    /// The names of the quantities; if there are none, the coordinates of all joints.
    pub(crate) quantities: Vec<String>,
    /// Over what it is shown, if not over what the mechanism is driven by.
    pub(crate) over: Option<String>,
    /// The motor that moves; without, the first, or all by their laws.
    pub(crate) motor: Option<String>,
    /// Where it begins and ends.
    pub(crate) span: Span,
    pub(crate) steps: u32,
    /// The speed of the motor, in radians or scene units per second: without, 1, and forces are those at rest.
    pub(crate) rate: Option<f64>,
    pub(crate) at: Vec<Setting>,
    /// Where the point of `follow` is led: it is measured there alone.
    pub(crate) reach: Option<Goal>,
    pub(crate) loads: Vec<Load>,
    pub(crate) units: Units,
    /// In a summary, the width within which dwells are looked for.
    pub(crate) dwell: Option<f64>,
}

impl Measure {
    /// The steps, if nobody says otherwise.
    pub(crate) const STEPS: u32 = 360;

    /// Moves the mechanism, and measures.
    pub(super) fn table(&self, Analysed { model, compiled }: &Analysed) -> Result<Table, Failure> {
        self.measured(model, compiled, None, quantity::measure)
    }

    /// The same, in summary.
    pub(super) fn summaries(
        &self,
        Analysed { model, compiled }: &Analysed,
    ) -> Result<Vec<Summary>, Failure> {
        self.measured(model, compiled, None, |of, wanted| {
            quantity::summarize(of, wanted, self.dwell)
        })
    }

    /// Measures what can be measured, and notes why the rest cannot.
    #[cfg(feature = "editor")]
    pub(crate) fn known_table(
        &self,
        model: &Model,
        compiled: &Compiled,
        missing: &mut Vec<Failure>,
    ) -> Result<Table, Failure> {
        self.measured(model, compiled, Some(missing), quantity::measure)
    }

    /// Without a list of what is missing, it fails if something is.
    fn measured<R>(
        &self,
        model: &Model,
        compiled: &Compiled,
        mut missing: Option<&mut Vec<Failure>>,
        measured: impl FnOnce(&Measurement<'_>, &[Measurand]) -> Result<R, Failure>,
    ) -> Result<R, Failure> {
        let mut miss = |failure| match &mut missing {
            Some(missing) => {
                missing.push(failure);
                Ok(())
            }
            None => Err(failure),
        };
        let mut wanted = Vec::new();
        for name in &self.quantities {
            match quantity::measurands(model, &compiled.plan, name) {
                Ok(found) => wanted.extend(found),
                Err(failure) => miss(failure)?,
            }
        }
        let mut over = None;
        if let Some(name) = &self.over {
            match quantity::only_measurand(model, &compiled.plan, name) {
                Ok(found) => over = Some(found),
                Err(failure) => miss(failure)?,
            }
        }
        if wanted.is_empty() && missing.is_none() {
            wanted = quantity::usual(model);
        }
        let (drive, steps) = if let Some(goal) = &self.reach {
            (Drive::led(model, compiled, &self.at, goal)?, 0)
        } else {
            let motor = self.motor.as_deref();
            let drive = Drive::new(model, compiled, motor, self.span, &self.at)?;
            (drive, self.steps)
        };
        let measurement = Measurement {
            model,
            drive: &drive,
            over,
            rate: self.rate,
            steps,
            loads: &self.loads,
            units: &self.units,
        };
        measured(&measurement, &wanted)
    }
}

impl Default for Measure {
    fn default() -> Self {
        Self {
            quantities: Vec::new(),
            over: None,
            motor: None,
            span: Span::default(),
            steps: Self::STEPS,
            rate: None,
            at: Vec::new(),
            reach: None,
            loads: Vec::new(),
            units: Units::default(),
            dwell: None,
        }
    }
}
