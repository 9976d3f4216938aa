//! Links and joints that are to be declared.

use super::{Repair, is_in_cam};
use crate::api::is_reserved;
use crate::bug::bug;
use crate::model::{Axis, AxisId, JointId, JointKind, LinkId, Model};

/// Links and joints that are to be declared, some in place of others.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Declaration {
    /// Their purpose.
    pub purpose: Purpose,
    /// A link that is to be declared with them. Their ends mean it by the number after that of the last link.
    pub link: Option<String>,
    /// The joints.
    pub joints: Vec<NewJoint>,
    /// The joints that they stand for.
    pub replaced: Vec<JointId>,
}

/// The purpose of a new joint.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Purpose {
    /// To pin a link to the ground.
    Ground,
    /// To join two links.
    Join {
        /// The distance in the drawing between their places for the joint, in scene units.
        apart: f64,
    },
    /// To join two links somewhere: nothing says where.
    Meet,
    /// To join two links as others are that are drawn like them.
    Twin,
    /// To connect two links by a third.
    Connect,
    /// To make one bent link of two.
    Stiffen,
    /// To let a link turn that only slides.
    Turn,
    /// To keep a link from turning that slides.
    Guide,
    /// To let a link slide on the ground.
    Slide,
    /// To let a link, or its pin, slide somewhere on another: nothing says where.
    Guess,
    /// To join links to each other that are pinned to the ground at one place.
    Free,
    /// To make a link a part of the ground.
    Fix,
    /// To make two links of one.
    Split,
}

/// A joint as it is to be written.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NewJoint {
    /// Its name.
    pub name: String,
    /// Its kind.
    pub kind: NewKind,
    /// Its ends.
    pub ends: Ends,
}

/// The kind of a joint that is to be declared: the motion that it allows. Directions are of length one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum NewKind {
    /// To turn.
    Revolute,
    /// Nothing.
    Weld,
    /// To slide in this direction of the scene.
    Prismatic([f64; 2]),
    /// To turn, and to slide in this direction of the scene: the first end has the pin.
    Slot([f64; 2]),
}

/// The ends of a joint that is to be declared.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Ends {
    /// Two links, at a place in the scene, as the drawing has them.
    Drawn {
        /// The links.
        links: [LinkId; 2],
        /// The place.
        at: [f64; 2],
    },
    /// Two points that links have in frames of their own: for a revolute joint.
    Points([AxisId; 2]),
}

impl Ends {
    /// The two links.
    #[must_use]
    pub fn links(&self, model: &Model) -> [LinkId; 2] {
        match *self {
            Self::Drawn { links, .. } => links,
            Self::Points(points) => points.map(|point| model.axis(point).link),
        }
    }
}

impl Declaration {
    /// One joint besides all others.
    pub(super) fn joint(purpose: Purpose, joint: NewJoint) -> Self {
        Self { purpose, link: None, joints: vec![joint], replaced: Vec::new() }
    }

    /// One joint in place of another.
    pub(super) fn instead(purpose: Purpose, joint: NewJoint, replaced: JointId) -> Self {
        Self { replaced: vec![replaced], ..Self::joint(purpose, joint) }
    }

    /// The kind and the links of the joint, wherever it is, if a declaration has that alone.
    pub(super) fn only_joint(&self) -> Option<(std::mem::Discriminant<NewKind>, [LinkId; 2])> {
        match &self.joints[..] {
            [NewJoint { kind, ends: Ends::Drawn { links: [a, b], .. }, .. }]
                if self.link.is_none() && self.replaced.is_empty() =>
            {
                Some((std::mem::discriminant(kind), [*a.min(b), *a.max(b)]))
            }
            _ => None,
        }
    }

    /// Whether the joints that it stands for can give way: they lie between axes, and neither a motor nor a cam needs them.
    pub(super) fn can_replace(&self, model: &Model) -> bool {
        let gives_way = |joint: &JointId| {
            let declared = model.joint(*joint);
            let between_axes = declared.kind.axes().is_some() && !declared.hidden;
            between_axes && model.motor_of(*joint).is_none() && !is_in_cam(model, *joint)
        };
        self.replaced.iter().all(gives_way)
    }

    /// The statements that are added, as they are written: the link, then the joints.
    pub(crate) fn statements(&self, model: &Model) -> Vec<String> {
        let link = self.link.iter().map(|name| format!("link {name};"));
        let joints = self.joints.iter();
        let joints = joints.map(|joint| self.joint_text(joint, model));
        link.chain(joints).collect()
    }

    /// One of its joints as it is written, with its semicolon.
    pub(super) fn joint_text(&self, joint: &NewJoint, model: &Model) -> String {
        let link = |id: LinkId| match (model.links.get(id.index()), &self.link) {
            (Some(link), _) => &link.name,
            (None, Some(new)) => new,
            (None, None) => bug!("a joint joins a link that is not declared"),
        };
        let (word, along) = match joint.kind {
            NewKind::Revolute => ("revolute", None),
            NewKind::Weld => ("weld", None),
            NewKind::Prismatic(along) => ("prismatic", Some(along)),
            NewKind::Slot(along) => ("slot", Some(along)),
        };
        let name = &joint.name;
        match joint.ends {
            Ends::Drawn { links, at: [x, y] } => {
                let [a, b] = links.map(link);
                let along = along.map(|along| {
                    let [x, y] = in_small_numbers(along);
                    format!(" along ({x}, {y})")
                });
                let along = along.unwrap_or_default();
                format!("joint {name} = {word}({a}, {b}) at ({x}, {y}){along};")
            }
            Ends::Points(points) => {
                let [a, b] = points.map(|id| {
                    let axis = model.axis(id);
                    format!("{}.{}", link(axis.link), axis.own_name())
                });
                format!("joint {name} = {word}({a}, {b});")
            }
        }
    }

    /// The names of the joints that it stands for and that have no heir of that name.
    pub(crate) fn dropped_names<'m>(&self, model: &'m Model) -> Vec<&'m str> {
        let names = self.replaced.iter().map(|&id| &*model.joint(id).name);
        names.filter(|name| self.joints.iter().all(|joint| joint.name != *name)).collect()
    }
}

/// A pin on the ground.
pub(super) fn on_ground(model: &Model, link: LinkId, name: Option<&str>, at: [f64; 2]) -> Repair {
    let name = NewNames::new(model).like(name, "pin");
    join(Purpose::Ground, name, [LinkId::GROUND, link], at)
}

/// A joint that turns, at a place.
pub(super) fn join(purpose: Purpose, name: String, links: [LinkId; 2], at: [f64; 2]) -> Repair {
    let joint = NewJoint { name, kind: NewKind::Revolute, ends: Ends::Drawn { links, at } };
    Declaration::joint(purpose, joint).into()
}

impl From<Declaration> for Repair {
    fn from(declaration: Declaration) -> Self {
        Self::Declare(declaration)
    }
}

/// Names for new links and joints.
pub(super) struct NewNames<'m> {
    model: &'m Model,
    given: Vec<String>,
}

impl<'m> NewNames<'m> {
    pub(super) fn new(model: &'m Model) -> Self {
        Self { model, given: Vec::new() }
    }

    /// This name, if nothing is called so and no method of the generated struct could be; else a plain one with a number.
    pub(super) fn like(&mut self, hint: Option<&str>, plain: &str) -> String {
        let plain_one = |number: usize| match number {
            1 => plain.to_owned(),
            _ => format!("{plain}{number}"),
        };
        let hint = hint.filter(|hint| hint.chars().all(|letter| letter.is_ascii_alphanumeric()));
        let hints = hint.map(ToOwned::to_owned).into_iter();
        let mut names = hints.chain((1..).map(plain_one));
        let name = names.find(|name| self.is_new(name)).unwrap_or_else(|| plain.to_owned());
        self.given.push(name.clone());
        name
    }

    fn is_new(&self, name: &str) -> bool {
        let model = self.model;
        let mut links = model.links.iter();
        let mut joints = model.joints.iter();
        let mut params = model.params.all().iter();
        !(links.any(|link| link.name == name)
            || joints.any(|joint| joint.name == name)
            || params.any(|param| param.name == name)
            || self.given.iter().any(|given| given == name)
            || is_reserved(name))
    }
}

/// The two links of a joint between axes, and where it is drawn; none if it is not drawn or depends on params.
pub(super) fn drawn_joint(model: &Model, joint: JointId) -> Option<([LinkId; 2], [f64; 2])> {
    let axes = model.joint(joint).kind.axes()?;
    let declared = axes.map(|id| model.axis(id));
    let unnamed = declared.iter().all(|axis| axis.name.is_none());
    let links = declared.map(|axis| axis.link);
    // A link with a joint is in the scene only if it is drawn.
    let is_drawn = |axis: &Axis| {
        let is_there = axis.link == LinkId::GROUND || model.link(axis.link).drawn;
        is_there && !axis.varies()
    };
    let drawn = unnamed && declared.into_iter().all(is_drawn);
    drawn.then(|| (links, declared[0].at))
}

/// Whether a joint is revolute and nobody asked for its coordinate by a motor.
pub(super) fn turns_freely(model: &Model, joint: JointId) -> bool {
    let declared = model.joint(joint);
    let turns = matches!(declared.kind, JointKind::Revolute(..)) && !declared.hidden;
    turns && model.motor_of(joint).is_none() && !is_in_cam(model, joint)
}

/// The same direction in whole numbers, if small ones give it.
fn in_small_numbers(direction: [f64; 2]) -> [f64; 2] {
    const LARGEST: u8 = 20;
    const EXACT: f64 = 1e-12;
    let most = direction[0].abs().max(direction[1].abs());
    let scaled = |largest: u8| direction.map(|part| part / most * f64::from(largest));
    let is_whole = |numbers: &[f64; 2]| {
        let off = |number: &f64| (number - number.round()).abs();
        numbers.iter().all(|number| off(number) < EXACT)
    };
    let found = (1..=LARGEST).map(scaled).find(is_whole);
    found.map_or(direction, |whole| whole.map(|part| part.round() + 0.0))
}
