//! The names that the user gave. The dies of slots are never named, and a slot's two joints are one.

use super::wording::{and, brief};
use super::{Words, wording};
use crate::model::{Axis, AxisId, AxisKind, JointId, JointKind, LinkId, ParamId};

impl Words<'_> {
    pub(super) fn axis(&self, id: AxisId) -> String {
        let axis = self.model.axis(id);
        // The point of a die stands for the line of its slot, and its line for the point.
        let stands_for = match (self.model.link(axis.link).die, axis.kind) {
            (Some((_, line)), AxisKind::Point) => Some(line),
            (Some((point, _)), AxisKind::Line) => Some(point),
            (None, _) => None,
        };
        self.declared_axis(stands_for.map_or(axis, |id| self.model.axis(id)))
    }

    fn declared_axis(&self, axis: &Axis) -> String {
        let link = &self.model.link(axis.link).name;
        match (&axis.name, axis.kind) {
            (Some(name), _) => format!("`{link}.{name}`"),
            (None, AxisKind::Point) => {
                format!("the point ({}, {}) of `{link}`", brief(axis.at[0]), brief(axis.at[1]))
            }
            (None, AxisKind::Line) => format!(
                "the line through ({}, {}) of `{link}`",
                brief(axis.at[0]),
                brief(axis.at[1])
            ),
        }
    }

    pub(super) fn link(&self, id: LinkId) -> String {
        format!("`{}`", self.model.link(id).name)
    }

    pub(super) fn joint(&self, id: JointId) -> String {
        format!("`{}`", self.model.joint(id).name)
    }

    /// The links that were declared, without the ground.
    pub(super) fn moving_links(&self, ids: &[LinkId]) -> Vec<LinkId> {
        let declared = |id: &LinkId| *id != LinkId::GROUND && self.model.link(*id).die.is_none();
        ids.iter().copied().filter(declared).collect()
    }

    pub(super) fn links(&self, ids: &[LinkId]) -> String {
        let names: Vec<String> = ids.iter().map(|&id| self.link(id)).collect();
        let word = if ids.len() == 1 { "link" } else { "links" };
        format!("{word} {}", and(&names))
    }

    /// The names of joints, each once.
    pub(super) fn joint_names(&self, ids: &[JointId]) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for &id in ids {
            let name = self.model.joint(id).name.as_str();
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// `a`, `b` and `c`.
    pub(super) fn joints(&self, ids: &[JointId]) -> String {
        let names = self.joint_names(ids);
        and(&names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>())
    }

    /// Joints with the word for them, and the verb that fits: `joint a stays` or `joints a, b stay`.
    pub(super) fn the_joints(&self, ids: &[JointId], [one, several]: [&str; 2]) -> String {
        let joints = self.joints(ids);
        if self.joint_names(ids).len() == 1 {
            format!("joint {joints} {one}")
        } else {
            format!("joints {joints} {several}")
        }
    }

    pub(super) fn motors(&self, ids: &[JointId]) -> String {
        let word = if ids.len() == 1 { "motor" } else { "motors" };
        format!("{word} {}", self.joints(ids))
    }

    /// A joint that would hold this link, in the words of the language.
    pub(super) fn some_joint(&self, link: LinkId) -> String {
        let name = &self.model.link(link).name;
        if self.model.links.iter().any(|link| link.drawn) {
            let mut axes = self.model.axes.iter();
            let point = axes.find(|axis| axis.link == link && axis.kind == AxisKind::Point);
            return match point {
                Some(Axis { at: [x, y], .. }) => {
                    format!("revolute(ground, {name}) at ({x}, {y})")
                }
                None => format!("revolute(ground, {name}) at (X, Y)"),
            };
        }
        let named = |owner: LinkId| {
            let mut axes = self.model.axes.iter();
            axes.find(|axis| {
                axis.link == owner && axis.kind == AxisKind::Point && axis.name.is_some()
            })
            .and_then(|axis| axis.name.as_ref())
            .map(|name| format!("{}.{name}", self.model.link(owner).name))
        };
        let mut others = self.model.link_ids().filter(|&other| other != link);
        match (named(link), others.find_map(named)) {
            (Some(point), Some(other)) => format!("revolute({other}, {point})"),
            _ => format!("revolute(ground, {name}) at (X, Y)"),
        }
    }

    /// Returns the word of the language for a joint that rolls.
    pub(super) fn rolling(&self, id: JointId) -> &'static str {
        self.model.joint(id).kind.plain().word()
    }

    /// Whether this joint was placed in the drawing.
    pub(super) fn is_drawn(&self, joint: JointId) -> bool {
        match self.model.joint(joint).kind {
            JointKind::Revolute(axis, _) | JointKind::Prismatic(axis, _) => {
                self.model.axis(axis).name.is_none()
            }
            _ => false,
        }
    }
}

impl Words<'_> {
    /// The name of a param.
    pub(super) fn param(&self, param: ParamId) -> &str {
        &self.model.params.all()[param.index()].name
    }

    pub(super) fn matched_only(&self, joints: &[JointId], param: ParamId) -> String {
        let param = self.param(param);
        let names: Vec<String> = joints.iter().map(|&joint| self.joint(joint)).collect();
        let some = wording::one_of(&names);
        format!(
            "this mechanism moves only as long as its lengths match, and param `{param}` may change one\nhelp: write `const \
             {param}`, or remove {some}"
        )
    }
}
