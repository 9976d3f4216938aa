//! Quantities: the numbers that a position gives, with the motion there and what acts.

use super::{AxisId, JointId, JointKind, LinkId, Model, MotorId};

/// A derivative by the time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Rate {
    /// The first.
    Velocity,
    /// The second.
    Acceleration,
}

impl Rate {
    /// Its word.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Velocity => "velocity",
            Self::Acceleration => "acceleration",
        }
    }
}

/// A number that the position of a mechanism gives, with how it moves there and what acts: in radians, scene units and units of force.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Quantity {
    /// The coordinate of a joint.
    Coordinate(JointId),
    /// The angle of a link in the scene, over whole turns.
    Angle(LinkId),
    /// The angle from one link to another.
    AngleBetween([LinkId; 2]),
    /// The abscissa of a point in the scene.
    X(AxisId),
    /// The ordinate of a point in the scene.
    Y(AxisId),
    /// The distance of two places, or of a place and a line.
    Distance([Spot; 2]),
    /// The least distance of the shapes of two links: zero where they overlap.
    Clearance([LinkId; 2]),
    /// The transmission angle: of the dyad that finds the coordinate of this joint, or without one of each dyad.
    Transmission(Option<JointId>),
    /// The pressure angle of a cam that has a roller.
    Pressure(JointId),
    /// The curvature of the curve on which the middle of a cam's roller runs: in parts of a scene unit, positive where it is convex.
    Curvature(JointId),
    /// The abscissa of the instant centre of two links.
    CentreX([LinkId; 2]),
    /// The ordinate of the instant centre of two links.
    CentreY([LinkId; 2]),
    /// The torque of a motor, or its force if it slides.
    Torque(MotorId),
    /// The torque of a motor times its rate.
    Power(MotorId),
    /// What the first link of a joint does to the second.
    Reaction(JointId, ReactionPart),
    /// What the ground gets in all: weights and loads, less what accelerates masses. Its torque is the moment about the origin.
    Ground(ReactionPart),
    /// The part of that which the inertia of all links makes.
    Shaking(ReactionPart),
    /// The mechanical advantage of a motor over the load of this number in its direction: one divided by the velocity ratio.
    Advantage(usize, MotorId),
    /// The time since the motion began, in a table.
    Time,
}

/// A part of a reaction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum ReactionPart {
    /// The force along the scene's x axis.
    X,
    /// The force along the scene's y axis.
    Y,
    /// The torque about the joint.
    Torque,
}

/// What a quantity is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// An angle, in radians.
    Angle,
    /// A length, in scene units.
    Length,
    /// Something else.
    Other,
}

impl Quantity {
    /// What it is.
    #[must_use]
    pub fn dimension(self, model: &Model) -> Dimension {
        match self {
            Self::Coordinate(joint) => match model.joint(joint).kind {
                JointKind::Revolute(..) => Dimension::Angle,
                _ => Dimension::Length,
            },
            Self::Angle(_) | Self::AngleBetween(_) | Self::Transmission(_) | Self::Pressure(_) => {
                Dimension::Angle
            }
            Self::X(_)
            | Self::Y(_)
            | Self::Distance(_)
            | Self::Clearance(_)
            | Self::CentreX(_)
            | Self::CentreY(_) => Dimension::Length,
            Self::Curvature(_)
            | Self::Torque(_)
            | Self::Power(_)
            | Self::Reaction(..)
            | Self::Ground(_)
            | Self::Shaking(_)
            | Self::Advantage(..)
            | Self::Time => Dimension::Other,
        }
    }

    /// Whether it is a force or a torque, or made from one.
    #[must_use]
    pub fn is_force(self) -> bool {
        self.needs_equilibrium() || matches!(self, Self::Ground(_) | Self::Shaking(_))
    }

    /// Whether it is found from the equilibrium of links.
    #[must_use]
    pub fn needs_equilibrium(self) -> bool {
        matches!(self, Self::Torque(_) | Self::Power(_) | Self::Reaction(..))
    }

    /// Whether loads have a part in it.
    #[must_use]
    pub fn takes_loads(self) -> bool {
        self.needs_equilibrium() || matches!(self, Self::Ground(_) | Self::Advantage(..))
    }

    /// Whether motors have to move for it.
    #[must_use]
    pub fn needs_motion(self) -> bool {
        matches!(self, Self::Power(_) | Self::CentreX(_) | Self::CentreY(_))
    }
}

/// A place from which a distance is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Spot {
    /// A point or a line of a link.
    Axis(AxisId),
    /// A place of the scene.
    At([f64; 2]),
}
