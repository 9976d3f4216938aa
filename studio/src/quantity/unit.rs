//! The units in which quantities are shown.

use super::kind::{Influenced, Order, Reaction, Subject};
use mech_compiler::model::{LoadKind, Model};

/// The names of a scene unit and of a unit of force.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Units {
    pub(crate) length: String,
    pub(crate) force: String,
}

impl Default for Units {
    fn default() -> Self {
        Self {
            length: "unit".to_owned(),
            force: "force".to_owned(),
        }
    }
}

impl Units {
    /// The unit of a quantity: angles are in degrees, their rates in radians.
    pub(crate) fn of(&self, model: &Model, subject: Subject) -> String {
        let Self { length, force } = self;
        let torque = || format!("{force}·{length}");
        match subject {
            Subject::Distance(_) | Subject::Clearance(_) | Subject::Centre(..) => length.clone(),
            Subject::Influence(of, motor) => {
                let above = match of {
                    Influenced::Angle(_) => "rad",
                    Influenced::Coordinate(joint) if model.turns(joint) => "rad",
                    Influenced::Point(..) | Influenced::Coordinate(_) => length,
                };
                let below = if model.turns(model.motor(motor).joint) {
                    "rad"
                } else {
                    length
                };
                if above == below {
                    "1".to_owned()
                } else {
                    format!("{above}/{below}")
                }
            }
            Subject::Power(_) => format!("{}/s", torque()),
            Subject::Angle(_, order) => rate("deg", "rad", order),
            Subject::Coordinate(joint, order) if model.turns(joint) => rate("deg", "rad", order),
            Subject::Point(_, order, _) | Subject::Coordinate(_, order) => {
                rate(length, length, order)
            }
            Subject::Torque(motor) if model.turns(model.motor(motor).joint) => torque(),
            Subject::Torque(_)
            | Subject::Reaction(_, Reaction::Force(_))
            | Subject::Ground(Reaction::Force(_))
            | Subject::Shaking(Reaction::Force(_)) => force.clone(),
            Subject::Reaction(_, Reaction::Torque)
            | Subject::Ground(Reaction::Torque)
            | Subject::Shaking(Reaction::Torque) => torque(),
            Subject::Advantage(load, motor) => {
                let is_force = matches!(model.actions.loads[load].kind, LoadKind::Force(_));
                match (is_force, model.turns(model.motor(motor).joint)) {
                    (true, true) => format!("1/{length}"),
                    (false, false) => length.clone(),
                    _ => "1".to_owned(),
                }
            }
            Subject::Between(_) | Subject::Transmission(_) | Subject::Pressure(_) => {
                "deg".to_owned()
            }
            Subject::Curvature(_) => format!("1/{length}"),
            Subject::Time => "s".to_owned(),
        }
    }

    /// A value in this unit, which is measured in radians if it is an angle.
    pub(crate) fn shown(&self, model: &Model, subject: Subject, value: f64) -> f64 {
        if self.of(model, subject) == "deg" {
            value.to_degrees()
        } else {
            value
        }
    }
}

fn rate(place: &str, unit: &str, order: Order) -> String {
    match order {
        Order::Place => place.to_owned(),
        Order::Velocity => format!("{unit}/s"),
        Order::Acceleration => format!("{unit}/s²"),
    }
}
