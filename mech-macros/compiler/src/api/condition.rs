//! The conditions under which an item of the API exists.

use crate::model::{LoadKind, Model};
use std::fmt::{self, Display, Formatter};

/// The statements of a text from which methods are made, right or wrong.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Asked {
    /// Whether a motor or a point has a law of the time.
    pub laws: bool,
    /// Whether motors follow a point.
    pub follow: bool,
}

/// The condition under which a mechanism has an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Condition {
    Always,
    /// The ranges of the motors are proved. A mechanism with errors has the item in any case.
    Ranges,
    /// A motor turns, and none slides. A mechanism with errors need not have a motor yet.
    Turning,
    TurningAndSliding,
    Velocity,
    VelocityOnly,
    Acceleration,
    /// Loads and springs have methods.
    Actions,
    Force,
    Dynamics,
    Overlay,
    OverlayOfVelocity,
    OverlayOfAcceleration,
    OverlayOfForce,
    OverlayOfLoads,
    Traces,
    /// More is painted than the shapes as they are at the start.
    PaintsMore,
    Params,
    Sensitivity,
    Laws,
    Inverse,
    InverseVelocity,
    InverseAcceleration,
}

impl Condition {
    /// Whether a mechanism meets it, as far as its text is understood.
    pub(crate) fn is_met(self, model: &Model, asked: Asked) -> bool {
        let effects = model.effects;
        let slides = || {
            let mut motors = model.motors.iter();
            motors.any(|motor| !model.turns(motor.joint))
        };
        let has_forces = || {
            let mut loads = model.actions.loads.iter();
            loads.any(|load| matches!(load.kind, LoadKind::Force(_)))
        };
        match self {
            Self::Always | Self::Ranges => true,
            Self::Turning => !slides(),
            Self::TurningAndSliding => slides(),
            Self::Velocity => effects.velocity,
            Self::VelocityOnly => effects.velocity && !effects.acceleration,
            Self::Acceleration => effects.acceleration,
            Self::Actions => effects.needs_actions(),
            Self::Force => effects.force,
            Self::Dynamics => effects.dynamics,
            Self::Overlay => effects.overlay,
            Self::OverlayOfVelocity => effects.overlay && effects.velocity,
            Self::OverlayOfAcceleration => effects.overlay && effects.acceleration,
            Self::OverlayOfForce => effects.overlay && effects.force,
            Self::OverlayOfLoads => effects.overlay && effects.force && has_forces(),
            Self::Traces => !model.traces.is_empty(),
            Self::PaintsMore => model.paints_more(),
            Self::Params => !model.params.is_empty(),
            Self::Sensitivity => effects.sensitivity && !model.params.is_empty(),
            Self::Laws => asked.laws,
            Self::Inverse => asked.follow,
            Self::InverseVelocity => asked.follow && effects.velocity && !effects.acceleration,
            Self::InverseAcceleration => asked.follow && effects.acceleration,
        }
    }

    /// The owner of the name of an item; none if the name is taken in every mechanism.
    pub(super) fn owner(self) -> Option<Owner> {
        match self {
            Self::Force => Some(Owner::Force),
            Self::Dynamics => Some(Owner::Dynamics),
            Self::OverlayOfForce | Self::OverlayOfLoads => Some(Owner::Overlay),
            Self::Params | Self::Sensitivity => Some(Owner::Params),
            Self::Laws => Some(Owner::Laws),
            Self::Inverse | Self::InverseVelocity | Self::InverseAcceleration => {
                Some(Owner::Inverse)
            }
            _ => None,
        }
    }
}

/// A feature that takes names only in the mechanisms that have it, displayed as messages call it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Owner {
    Force,
    Dynamics,
    Overlay,
    Params,
    Laws,
    Inverse,
}

impl Owner {
    #[cfg(test)]
    pub(crate) const ALL: [Self; 6] =
        [Self::Force, Self::Dynamics, Self::Overlay, Self::Params, Self::Laws, Self::Inverse];
}

impl Display for Owner {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Force => "effect `force`",
            Self::Dynamics => "effect `dynamics`",
            Self::Overlay => "effect `overlay`",
            Self::Params => "a mechanism with params",
            Self::Laws => "the method that moves motors by their laws",
            Self::Inverse => "the method that moves motors after a point",
        })
    }
}
