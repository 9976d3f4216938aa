//! What must be computed besides positions.

use super::turning::Chain;
use mech_compiler::model::{Effects, JointId, LinkId, Measurand, Measured, Model, Quantity, Rate};

/// What must be computed besides positions.
#[derive(Clone, Debug, Default)]
pub(super) struct Needs {
    pub(super) velocity: bool,
    pub(super) acceleration: bool,
    pub(super) force: bool,
    /// The links whose angles over whole turns are measured.
    pub(super) links: Vec<LinkId>,
    /// The joints whose coordinates are measured.
    pub(super) joints: Vec<JointId>,
}

impl Needs {
    /// The needs of these measurands.
    pub(super) fn of(measurands: &[Measurand]) -> Self {
        let mut needs = Self::default();
        for measurand in measurands {
            for measured in measurand.own() {
                match measured {
                    Measured::Quantity(quantity) => needs.add(*quantity),
                    Measured::Influence(of, _) => {
                        needs.velocity = true;
                        for number in measurand.formulas().variables(*of) {
                            if let Some(quantity) = measurand.measured()[number].quantity() {
                                needs.add(quantity);
                            }
                        }
                    }
                    Measured::Rate(rate, _) => needs.add_rate(*rate),
                    Measured::Summary(..) => {}
                }
            }
        }
        needs
    }

    /// Rates of this order, too.
    pub(super) fn add_rate(&mut self, rate: Rate) {
        self.velocity = true;
        self.acceleration |= rate == Rate::Acceleration;
    }

    fn add(&mut self, quantity: Quantity) {
        match quantity {
            Quantity::Coordinate(joint) => self.joints.push(joint),
            Quantity::Angle(link) => self.links.push(link),
            Quantity::AngleBetween(links) => self.links.extend(links),
            Quantity::CentreX(_) | Quantity::CentreY(_) | Quantity::Advantage(..) => {
                self.velocity = true;
            }
            Quantity::Ground(_) | Quantity::Shaking(_) => self.add_rate(Rate::Acceleration),
            Quantity::Torque(_)
            | Quantity::Power(_)
            | Quantity::Reaction(..)
            | Quantity::Transmission(_) => self.force = true,
            Quantity::X(_)
            | Quantity::Y(_)
            | Quantity::Distance(_)
            | Quantity::Clearance(_)
            | Quantity::Pressure(_)
            | Quantity::Curvature(_)
            | Quantity::Time => {}
        }
    }

    /// A mechanism with everything shown that computes all this, whatever effects it has: angles go on over whole turns however long a
    /// step is.
    pub(super) fn added_to(&self, model: &Model) -> Model {
        let mut whole = Model { show: None, ..model.clone() };
        let Effects { velocity, acceleration, force, .. } = &mut whole.effects;
        *velocity |= self.velocity || self.acceleration || self.force;
        *acceleration |= self.acceleration || self.force;
        *force |= self.force;
        let continuous = &mut whole.continuous;
        continuous.extend(&self.joints);
        for link in &self.links {
            continuous.extend(Chain::to(model, *link).joints());
        }
        continuous.retain(|&joint| model.turns(joint));
        continuous.sort_unstable();
        continuous.dedup();
        whole
    }
}
