//! Inverse kinematics: a point or a pose is given, and motors follow.

use super::{
    Actions, AxisId, DrawnAxis, Effects, FORWARD, Joint, JointId, JointKind, LawId, Link, LinkId,
    Model, Motor, MotorId, Origin, Range, Start,
};

/// A point that is given, or a point and the angle of its link, and the motors that follow.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Inverse {
    /// The link that is led: not the ground.
    pub link: LinkId,
    /// The point of it that is given; without, the origin of its frame.
    pub point: Option<AxisId>,
    /// The motors that follow, each once: two for the place of the point, three for the angle of the link, too.
    pub motors: Vec<MotorId>,
    /// Whether they are more than that, and go as little as they can.
    pub is_least: bool,
    /// The values of what is given everywhere within which it is proved to come, one range for each, or none.
    pub region: Vec<Range>,
    /// The laws of what is given, one for each, or none: the path of the point.
    pub trajectory: Vec<LawId>,
    /// Where the point was named.
    pub origin: Origin,
    /// Where each motor was named.
    pub named: Vec<Origin>,
}

impl Inverse {
    /// The names of what is given, in the order in which it is.
    pub const GIVEN: [&'static str; 3] = ["x", "y", "angle"];

    /// The number of the angle among what is given.
    pub const ANGLE: usize = 2;

    /// Whether the angle of the link is given, too.
    #[must_use]
    pub fn gives_angle(&self) -> bool {
        if self.is_least { self.point.is_none() } else { self.motors.len() == Self::GIVEN.len() }
    }

    /// The names of what is given.
    #[must_use]
    pub fn given(&self) -> &'static [&'static str] {
        &Self::GIVEN[..if self.gives_angle() { 3 } else { 2 }]
    }

    /// The number of what is given in place of a motor; none of a motor that does not follow.
    #[must_use]
    pub fn given_by(&self, motor: MotorId) -> Option<usize> {
        self.motors.iter().position(|one| *one == motor)
    }

    /// The point or the link, as it is named: `pen.tip`.
    #[must_use]
    pub fn name(&self, model: &Model) -> String {
        match self.point {
            None => model.link(self.link).name.clone(),
            Some(point) => {
                let axis = model.axis(point);
                format!("{}.{}", model.owner_of(axis), axis.own_name())
            }
        }
    }
}

impl Model {
    /// The mechanism in which the point is given: two slides on the ground carry it, and its link turns on them, driven if its angle is
    /// given. Their motors stand in place of those that follow. Nothing else is computed of it, and its start is open.
    pub(crate) fn inverted(&self, inverse: &Inverse) -> Self {
        let mut other = Self {
            inverse: None,
            show: None,
            method: None,
            accuracy: None,
            traces: Vec::new(),
            requirements: Vec::new(),
            effects: Effects::default(),
            actions: Actions::default(),
            start: Start::default(),
            ..self.clone()
        };
        let following = inverse.motors.iter().map(|motor| self.motor(*motor).joint);
        other.continuous.extend(following);
        let carrying = other.add_carriage(inverse);
        for (number, (motor, joint)) in inverse.motors.iter().zip(carrying).enumerate() {
            other.motors[motor.index()] = Motor {
                range: inverse.region.get(number).copied(),
                ..Motor::new(joint, inverse.origin)
            };
        }
        other
    }

    /// Adds what carries the point: the joints whose coordinates are what is given.
    fn add_carriage(&mut self, inverse: &Inverse) -> [JointId; 3] {
        let origin = inverse.origin;
        // Dies come after all other links.
        let dies = self.links.iter().position(|link| link.die.is_some());
        let first = dies.unwrap_or(self.links.len());
        for axis in &mut self.axes {
            if axis.link.index() >= first {
                axis.link = LinkId::new(axis.link.index() + 2);
            }
        }
        let [across, along] = [("across", first), ("along", first + 1)].map(|(name, number)| {
            self.links.insert(number, Link::new(name, origin));
            LinkId::new(number)
        });
        let mut line = |link, direction| {
            let line = DrawnAxis::line([0.0; 2], direction);
            self.add_drawn_axis(link, line, origin)
        };
        let rails = [LinkId::GROUND, across].map(|link| line(link, FORWARD));
        let guides = [across, along].map(|link| line(link, [0.0, 1.0]));
        let pin = self.add_drawn_axis(along, DrawnAxis::point([0.0; 2]), origin);
        let point = inverse.point.map(|point| self.axis(point));
        let place = point.map_or(DrawnAxis::point([0.0; 2]), |point| DrawnAxis {
            formulas: point.formulas,
            ..DrawnAxis::point(point.at)
        });
        let tip = self.add_drawn_axis(inverse.link, place, origin);
        let last =
            if inverse.gives_angle() { Inverse::GIVEN[2].to_owned() } else { inverse.name(self) };
        let kinds = [
            (Inverse::GIVEN[0].to_owned(), JointKind::Prismatic(rails[0], rails[1])),
            (Inverse::GIVEN[1].to_owned(), JointKind::Prismatic(guides[0], guides[1])),
            (last, JointKind::Revolute(pin, tip)),
        ];
        kinds.map(|(name, kind)| {
            self.joints.push(Joint { name, origin, kind, hidden: false });
            JointId::new(self.joints.len() - 1)
        })
    }
}
