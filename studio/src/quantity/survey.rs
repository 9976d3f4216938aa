//! Everything that is known of a mechanism in parts of a motion.

use super::load::{self, Load};
use super::measurement::compiled_for;
use super::meter::{Meter, needs_reactions};
use super::needs::Needs;
use super::position::Position;
use super::turning::whole_angle;
use crate::failure::Failure;
use crate::motion::Drive;
use mech_compiler::Compiled;
use mech_compiler::model::{Between, JointId, Model, Rate};

/// A mechanism, compiled for what is asked for, and where it is in some parts of a motion: its motor moves at a rate of 1, and forces are
/// those at rest. By laws, motors have their own rates.
pub(crate) struct Survey {
    model: Model,
    compiled: Compiled,
    loads: Vec<f64>,
    /// In the order of the parts. Where a rate is not determined, a position has none.
    pub(crate) positions: Vec<Position>,
}

/// A mechanism that is compiled for what is asked for, and the numbers of all its loads.
#[derive(Clone, Copy)]
pub(crate) struct Surveyed<'s> {
    pub(crate) model: &'s Model,
    pub(crate) compiled: &'s Compiled,
    pub(crate) loads: &'s [f64],
}

impl Surveyed<'_> {
    /// The coordinate of a joint on which a spring acts, over whole turns.
    pub(crate) fn twist(&self, at: &Position, joint: JointId) -> Option<f64> {
        whole_angle(self.model, self.compiled, at, joint)
    }
}

impl Survey {
    /// Moves a mechanism, and finds its rates up to an order, and its forces if they are asked for.
    pub(crate) fn new(
        model: &Model,
        drive: &Drive,
        parts: &[f64],
        rate: Rate,
        forces: Option<&[Load]>,
    ) -> Result<Self, Failure> {
        let mut needs = Needs::default();
        needs.add_rate(rate);
        let springs = model.actions.springs.iter().filter(|_| forces.is_some());
        needs.force = forces.is_some();
        needs.joints = springs
            .filter_map(|spring| match spring.between {
                Between::Joint(joint) => Some(joint),
                Between::Points(..) => None,
            })
            .collect();
        let loads = load::numbers(model, forces.unwrap_or_default())?;
        let model = needs.added_to(model);
        let compiled = compiled_for(&model)?;
        if needs.force {
            needs_reactions(&compiled)?;
        }
        let mut meter = Meter::of_needs(&model, &compiled, &needs, loads.clone());
        let positions = drive.attempt(|drive| {
            let mut positions: Vec<Position> = parts.iter().map(|_| Position::default()).collect();
            drive.visit(&model, &compiled, parts, |number, at| {
                let moments = drive.moments(&model, &compiled, parts[number], [1.0, 0.0]);
                positions[number] = meter.position(at, moments.each_ref())?;
                Ok(())
            })?;
            Ok(positions)
        })?;
        Ok(Self { model, compiled, loads, positions })
    }

    /// What is surveyed.
    pub(crate) fn subject(&self) -> Surveyed<'_> {
        let Self { model, compiled, loads, .. } = self;
        Surveyed { model, compiled, loads }
    }
}
