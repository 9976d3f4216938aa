//! Links that cannot stay where they are drawn.

use super::Words;
use crate::model::{Axis, AxisId, JointId, JointKind, LinkId, Origin};

/// By how much two places, or directions, of the drawing may miss each other, in sizes of the mechanism.
const SLACK: f64 = 1e-7;

/// A joint that is open in the drawing: its two axes are in different places of the scene.
struct Apart {
    joint: JointId,
    /// That of a link that is placed by `at`, but was given in numbers.
    given: AxisId,
    other: AxisId,
}

impl Words<'_> {
    pub(super) fn not_as_drawn(&self, link: LinkId) -> (Origin, String) {
        let reason = self.cam_off_the_drawing();
        reason.or_else(|| self.frame_of_the_scene()).unwrap_or_else(|| {
            let text = format!(
                "link {} cannot stay where it is drawn{}{}\nhelp: draw it where those lengths lead, or change them to fit \
                 the drawing",
                self.link(link),
                self.not_drawn(),
                self.given_in_the_scene(link)
            );
            (self.model.link(link).origin, text)
        })
    }

    /// The links that are not in the drawing, as the reason why one that is cannot stay.
    fn not_drawn(&self) -> String {
        let links: Vec<LinkId> =
            self.model.declared_links().filter(|&link| !self.model.link(link).drawn).collect();
        match links[..] {
            [] => String::new(),
            [_] => format!(": {}, which has lengths of its own, does not fit", self.links(&links)),
            _ => format!(": {}, which have lengths of their own, do not fit", self.links(&links)),
        }
    }

    /// A note that what this link declares of its own is in scene coordinates, because one of its joints is placed by `at`.
    fn given_in_the_scene(&self, link: LinkId) -> String {
        let own = self.model.joint_ids().find_map(|joint| {
            let mut axes = self.model.joint(joint).kind.axes()?.into_iter();
            axes.find(|&id| {
                let axis = self.model.axis(id);
                axis.link == link && axis.name.is_some()
            })
        });
        match (self.placed_by(link), own) {
            (Some(joint), Some(axis)) => format!(
                "\nnote: joint {} is placed by `at`: so the frame of {} is the scene's, and {} is given in it",
                self.joint(joint),
                self.link(link),
                self.axis(axis)
            ),
            _ => String::new(),
        }
    }

    /// The joint whose `at` makes the frame of a link that of the scene.
    fn placed_by(&self, link: LinkId) -> Option<JointId> {
        self.model.joint_ids().find(|&joint| {
            let (a, b) = self.model.ends(joint);
            (a == link || b == link) && self.is_drawn(joint)
        })
    }

    /// Two axes in the scene that a joint cannot bring together, because neither frame can move.
    fn frame_of_the_scene(&self) -> Option<(Origin, String)> {
        let Apart { joint, given, other } =
            self.model.joint_ids().find_map(|joint| self.apart(joint))?;
        let axis = self.model.axis(given);
        let place = self.placed_by(axis.link)?;
        let text = format!(
            "link {link} cannot stay where it is drawn: joint {place} is placed by `at`, so the frame of {link} is the scene's\n\
             note: joint {joint} joins {given} to {other}, but in the scene they are apart\n\
             help: write `{offer}` in {link}, or place {joint} by `at`, too",
            link = self.link(axis.link),
            place = self.joint(place),
            joint = self.joint(joint),
            given = self.axis(given),
            other = self.axis(other),
            offer = self.moved_axis(joint, given, other),
        );
        Some((axis.origin, text))
    }

    /// Whether a joint joins axes that lie apart in the scene, each fixed to it.
    fn apart(&self, joint: JointId) -> Option<Apart> {
        let kind = self.model.joint(joint).kind;
        let [a, b] = kind.axes()?;
        let (first, second) = (self.model.axis(a), self.model.axis(b));
        let in_scene =
            |axis: &Axis| axis.link == LinkId::GROUND || self.model.link(axis.link).drawn;
        if !in_scene(first) || !in_scene(second) || self.is_together(kind, first, second) {
            return None;
        }
        let is_given = |axis: &Axis| axis.link != LinkId::GROUND && axis.name.is_some();
        let (given, other) = match (is_given(first), is_given(second)) {
            (_, true) => (b, a),
            (true, false) => (a, b),
            (false, false) => return None,
        };
        Some(Apart { joint, given, other })
    }

    /// Whether two axes in the scene lie as a joint wants them, wherever its coordinate is.
    fn is_together(&self, kind: JointKind, a: &Axis, b: &Axis) -> bool {
        let [x, y] = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
        let [c, s] = a.direction;
        let near = |value: f64, scale: f64| value.abs() <= SLACK * scale;
        let size = self.model.size();
        let along = near(b.direction[0] - c, 1.0) && near(b.direction[1] - s, 1.0);
        match kind {
            JointKind::Prismatic(..) => along && near(x * s - y * c, size),
            JointKind::Weld(..) => along && near(x, size) && near(y, size),
            _ => near(x, size) && near(y, size),
        }
    }

    /// An axis as it is declared where the other one is.
    fn moved_axis(&self, joint: JointId, given: AxisId, other: AxisId) -> String {
        let (axis, there) = (self.model.axis(given), self.model.axis(other));
        let name = axis.own_name();
        let (a, _) = self.model.ends(joint);
        let offset = self.model.start.value(joint) * if a == axis.link { -1.0 } else { 1.0 };
        let [c, s] = there.direction;
        let [x, y] = there.at;
        match self.model.joint(joint).kind {
            JointKind::Prismatic(..) => {
                let (x, y) = (x + offset * c, y + offset * s);
                format!("line {name} = ({x}, {y}) -> ({c}, {s});")
            }
            JointKind::Weld(..) => format!("point {name} = ({x}, {y}) -> ({c}, {s});"),
            _ => format!("point {name} = ({x}, {y});"),
        }
    }
}
