//! The links, points and joints of a mechanism that are to be shown.

use super::{AxisId, AxisKind, Between, JointId, JointKind, LinkId, Model};

/// One of the things that are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Shown {
    /// The pose of a link, and with it its points and its shapes.
    Link(LinkId),
    /// The place of a point.
    Point(AxisId),
    /// The coordinate of a joint.
    Joint(JointId),
}

impl Model {
    /// The links whose poses are asked for or needed for what is, in the order of their declaration.
    #[must_use]
    pub fn asked_links(&self) -> Vec<LinkId> {
        let needs_all = self.effects.needs_actions() || self.inverse.is_some();
        let Some(shown) = self.show.as_ref().filter(|_| !needs_all) else {
            return self.declared_links().collect();
        };
        let mut links: Vec<LinkId> = shown
            .iter()
            .flat_map(|shown| self.links_of(*shown))
            .chain(self.traced_links())
            .filter(|link| *link != LinkId::GROUND)
            .collect();
        links.sort_unstable();
        links.dedup();
        links
    }

    /// The links whose poses give what is asked for. A motor's coordinate needs none.
    fn links_of(&self, shown: Shown) -> Vec<LinkId> {
        match shown {
            Shown::Link(link) => vec![link],
            Shown::Point(point) => vec![self.axis(point).link],
            Shown::Joint(joint) if self.motor_of(joint).is_some() => Vec::new(),
            Shown::Joint(joint) => match self.joint(joint).kind {
                JointKind::Revolute(a, b) | JointKind::Prismatic(a, b) => {
                    [a, b].map(|axis| self.axis(self.seen_axis(axis)).link).to_vec()
                }
                _ => Vec::new(),
            },
        }
    }

    /// The axis that lies where this one lies and whose link has a pose: instead of a die, its pin.
    #[must_use]
    pub fn seen_axis(&self, axis: AxisId) -> AxisId {
        let die = self.link(self.axis(axis).link).die;
        die.map_or(axis, |(pin, _)| pin)
    }

    /// The named points of the moving links that are asked for.
    pub fn shown_points(&self) -> impl Iterator<Item = AxisId> + '_ {
        let all = (0..self.axes.len()).map(AxisId::new);
        all.filter(|&id| {
            let axis = self.axis(id);
            let moves = axis.kind == AxisKind::Point && axis.link != LinkId::GROUND;
            moves && axis.name.is_some() && self.shows_point(id)
        })
    }

    /// The joints whose coordinates are asked for.
    pub fn shown_joints(&self) -> impl Iterator<Item = JointId> + '_ {
        self.declared_joints().filter(|&id| {
            let kind = self.joint(id).kind;
            let moves = matches!(kind, JointKind::Revolute(..) | JointKind::Prismatic(..));
            moves && self.shows_joint(id)
        })
    }

    /// The joints whose coordinates are asked for and follow from those of the motors.
    pub fn dependent_joints(&self) -> impl Iterator<Item = JointId> + '_ {
        self.shown_joints().filter(|&id| self.motor_of(id).is_none())
    }

    /// Whether the pose of a link is asked for.
    #[must_use]
    pub fn shows_link(&self, link: LinkId) -> bool {
        self.shows(Shown::Link(link))
    }

    /// Whether a point is asked for, by itself or with its link.
    #[must_use]
    pub fn shows_point(&self, point: AxisId) -> bool {
        let axis = self.axis(point);
        axis.kind == AxisKind::Point
            && (self.shows(Shown::Point(point)) || self.shows_link(axis.link))
    }

    /// Whether the coordinate of a joint is asked for.
    #[must_use]
    pub fn shows_joint(&self, joint: JointId) -> bool {
        self.shows(Shown::Joint(joint))
    }

    /// The revolute joints whose coordinates a position carries over whole turns, where no motor gives them: those for which that
    /// was asked, and those with torsional springs, if forces are computed.
    #[must_use]
    pub fn continuous_joints(&self) -> Vec<JointId> {
        let springs = self.actions.springs.iter();
        let sprung = springs.filter_map(|spring| match spring.between {
            Between::Joint(joint) => Some(joint),
            Between::Points(..) => None,
        });
        let sprung = sprung.filter(|_| self.effects.needs_actions());
        let asked = self.continuous.iter().copied();
        let mut joints: Vec<JointId> =
            asked.chain(sprung).filter(|&joint| self.motor_of(joint).is_none()).collect();
        joints.sort_unstable();
        joints.dedup();
        joints
    }

    fn shows(&self, wanted: Shown) -> bool {
        self.show.as_ref().is_none_or(|shown| shown.contains(&wanted))
    }
}
