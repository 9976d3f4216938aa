//! The kinds of quantities.

use mech_compiler::model::{AxisId, Effects, JointId, LinkId, MotorId};

/// A number that can be measured at a position.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Quantity {
    /// Its name: `velocity:coupler.tip.x`.
    pub(crate) name: String,
    pub(crate) subject: Subject,
}

impl Quantity {
    /// The links whose angles over whole turns it takes.
    pub(super) fn turning_links(&self) -> Vec<LinkId> {
        match self.subject {
            Subject::Angle(link, Order::Place) => vec![link],
            Subject::Between(links) => links.to_vec(),
            _ => Vec::new(),
        }
    }

    /// Whether it is the transmission angle of a dyad.
    pub(crate) fn is_transmission(&self) -> bool {
        matches!(self.subject, Subject::Transmission(_))
    }

    /// Whether it takes what accelerates all masses.
    pub(super) fn is_of_ground(&self) -> bool {
        matches!(self.subject, Subject::Ground(_) | Subject::Shaking(_))
    }

    /// The motor whose influence it is, if it is one.
    pub(super) fn motor(&self) -> Option<MotorId> {
        match self.subject {
            Subject::Influence(_, motor) | Subject::Advantage(_, motor) => Some(motor),
            _ => None,
        }
    }

    /// The cam whose contact it measures, if it does.
    pub(super) fn cam(&self) -> Option<JointId> {
        match self.subject {
            Subject::Pressure(cam) | Subject::Curvature(cam) => Some(cam),
            _ => None,
        }
    }

    /// The joint whose coordinate it is, if it is one.
    pub(crate) fn joint(&self) -> Option<JointId> {
        match self.subject {
            Subject::Coordinate(joint, Order::Place) => Some(joint),
            _ => None,
        }
    }
}

/// The subject of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Subject {
    /// A point, or its velocity or acceleration.
    Point(AxisId, Order, Part),
    /// The angle of a link in the scene, or its angular velocity or acceleration.
    Angle(LinkId, Order),
    /// The coordinate of a joint, or its rates.
    Coordinate(JointId, Order),
    /// The distance of two places.
    Distance([Spot; 2]),
    /// The least distance of the shapes of two links.
    Clearance([LinkId; 2]),
    /// The angle from one link to another.
    Between([LinkId; 2]),
    /// The instant centre of two links.
    Centre([LinkId; 2], Part),
    /// The influence coefficient of a motor on something: its rate if this motor alone moves, at a rate of 1.
    Influence(Influenced, MotorId),
    /// The power of a motor that moves so.
    Power(MotorId),
    /// The torque of a motor that makes the mechanism move so, or its force if it slides.
    Torque(MotorId),
    /// The force, or the torque about the joint, that the first link of a joint exerts on the second.
    Reaction(JointId, Reaction),
    /// What the ground gets in all: a force, and its moment about the origin.
    Ground(Reaction),
    /// The part of that by which the inertia of all links shakes the ground.
    Shaking(Reaction),
    /// The mechanical advantage of a motor over a load, which is given by its number.
    Advantage(usize, MotorId),
    /// The transmission angle of a dyad, by its number.
    Transmission(usize),
    /// The pressure angle of a cam.
    Pressure(JointId),
    /// The curvature of the curve on which a cam's roller runs.
    Curvature(JointId),
    /// The time since the motion began.
    Time,
}

/// What a motor moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Influenced {
    /// A point.
    Point(AxisId, Part),
    /// The angle of a link in the scene.
    Angle(LinkId),
    /// The coordinate of a joint.
    Coordinate(JointId),
}

impl Influenced {
    /// Its rate.
    pub(super) fn rate(self) -> Subject {
        match self {
            Self::Point(point, part) => Subject::Point(point, Order::Velocity, part),
            Self::Angle(link) => Subject::Angle(link, Order::Velocity),
            Self::Coordinate(joint) => Subject::Coordinate(joint, Order::Velocity),
        }
    }
}

/// A place from which a distance is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Spot {
    /// A point of a link.
    Point(AxisId),
    /// A place of the scene.
    At([f64; 2]),
}

/// The number of differentiations by time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Order {
    /// Not at all.
    Place,
    /// Once.
    Velocity,
    /// Twice.
    Acceleration,
}

/// A part of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// In the direction of the scene's x axis.
    X,
    /// In the direction of the scene's y axis.
    Y,
    /// Its length.
    Norm,
}

/// A part of a reaction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reaction {
    /// Of its force.
    Force(Part),
    /// The torque about the joint.
    Torque,
}

/// The rates and forces that must be computed besides positions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Needs {
    pub(crate) velocity: bool,
    pub(crate) acceleration: bool,
    pub(crate) force: bool,
}

impl Needs {
    /// Returns the needs of these quantities.
    pub(crate) fn of(quantities: &[Quantity]) -> Self {
        let mut needs = Self::default();
        for quantity in quantities {
            match quantity.subject {
                Subject::Point(_, order, _)
                | Subject::Angle(_, order)
                | Subject::Coordinate(_, order) => {
                    needs.velocity |= order >= Order::Velocity;
                    needs.acceleration |= order >= Order::Acceleration;
                }
                Subject::Centre(..) | Subject::Influence(..) | Subject::Advantage(..) => {
                    needs.velocity = true;
                }
                Subject::Ground(_) | Subject::Shaking(_) => needs.acceleration = true,
                Subject::Torque(_)
                | Subject::Power(_)
                | Subject::Reaction(..)
                | Subject::Transmission(_) => {
                    needs.force = true;
                }
                Subject::Distance(_)
                | Subject::Between(_)
                | Subject::Clearance(_)
                | Subject::Pressure(_)
                | Subject::Curvature(_)
                | Subject::Time => {}
            }
        }
        needs
    }

    /// These effects besides those that are declared.
    pub(crate) fn add_to(self, effects: &mut Effects) {
        effects.velocity |= self.velocity || self.acceleration || self.force;
        effects.acceleration |= self.acceleration || self.force;
        effects.force |= self.force;
    }
}
