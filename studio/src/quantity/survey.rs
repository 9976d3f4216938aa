//! Everything that is known of a mechanism in parts of a motion.

use super::kind::{Order, Part, Quantity, Reaction, Subject};
use super::load::{self, Load};
use super::measurement::{compiled_for, with_needs};
use super::meter::Meter;
use super::position::Position;
use super::turning::whole_angle;
use crate::failure::Failure;
use crate::motion::Drive;
use mech_compiler::Compiled;
use mech_compiler::model::{Between, JointId, Model};

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
        order: Order,
        forces: Option<&[Load]>,
    ) -> Result<Self, Failure> {
        let rates = model
            .declared_links()
            .map(|link| Subject::Angle(link, order));
        let reactions = model
            .declared_joints()
            .map(|joint| Subject::Reaction(joint, Reaction::Force(Part::Norm)));
        let springs = model.actions.springs.iter();
        let twists = springs.filter_map(|spring| match spring.between {
            Between::Joint(joint) => Some(Subject::Coordinate(joint, Order::Place)),
            Between::Points(..) => None,
        });
        let within = reactions.chain(twists).filter(|_| forces.is_some());
        let named = |subject| Quantity {
            name: String::new(),
            subject,
        };
        let quantities: Vec<Quantity> = rates.chain(within).map(named).collect();
        let loads = load::numbers(model, forces.unwrap_or_default())?;
        let model = with_needs(model, &quantities);
        let compiled = compiled_for(&model)?;
        let mut meter = Meter::new(&model, &compiled, &quantities, loads.clone())?;
        let positions = drive.attempt(|drive| {
            let mut positions: Vec<Position> = parts.iter().map(|_| Position::default()).collect();
            drive.visit(&model, &compiled, parts, |number, at| {
                let moments = drive.moments(&model, &compiled, parts[number], [1.0, 0.0]);
                positions[number] = meter.position(at, moments.each_ref(), &quantities)?;
                Ok(())
            })?;
            Ok(positions)
        })?;
        Ok(Self {
            model,
            compiled,
            loads,
            positions,
        })
    }

    /// What is surveyed.
    pub(crate) fn subject(&self) -> Surveyed<'_> {
        let Self {
            model,
            compiled,
            loads,
            ..
        } = self;
        Surveyed {
            model,
            compiled,
            loads,
        }
    }
}
