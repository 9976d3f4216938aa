//! Where the parts of a model are found: made once, for all poses.

use super::Item;
use mech_compiler::model::{AxisId, AxisKind, JointId, JointKind, Model};
use std::collections::HashMap;

/// The look of a handle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HandleKind {
    /// A joint that turns.
    Pin,
    /// A joint that slides.
    Slide,
    /// A joint that welds.
    Weld,
    /// A point without a joint.
    Point,
    /// A line without a joint.
    Line,
}

/// The parts of a model by their names and by the links that they are on.
#[derive(Debug)]
pub(super) struct Index {
    /// The joints that are shown, by their names.
    pub(super) joints: HashMap<String, JointId>,
    /// The points and lines that have a name, by their paths.
    pub(super) axes: HashMap<String, AxisId>,
    /// The points and lines of each link.
    pub(super) on_link: Vec<Vec<AxisId>>,
    /// Where each link turns: the axis of its first joint that does.
    pub(super) pivots: Vec<Option<AxisId>>,
    /// The joint by which each link rolls on another, and whether the link is its first or its second.
    pub(super) wheels: Vec<Option<(JointId, usize)>>,
    /// The items that can be taken hold of, with their axes and looks; joints first.
    pub(super) handles: Vec<(Item, AxisId, HandleKind)>,
}

impl Index {
    pub(super) fn of(model: &Model) -> Self {
        let mut on_link = vec![Vec::new(); model.links.len()];
        let mut axes = HashMap::new();
        for axis in axis_ids(model) {
            on_link[model.axis(axis).link.index()].push(axis);
            if let Some(path) = path(model, axis) {
                axes.entry(path).or_insert(axis);
            }
        }
        let mut joints = HashMap::new();
        let mut pivots = vec![None; model.links.len()];
        for joint in model.declared_joints() {
            joints.entry(model.joint(joint).name.clone()).or_insert(joint);
            if let JointKind::Revolute(a, b) = model.joint(joint).kind {
                for end in [a, b] {
                    pivots[model.axis(end).link.index()].get_or_insert(a);
                }
            }
        }
        Self {
            joints,
            axes,
            on_link,
            wheels: wheels(model, &pivots),
            pivots,
            handles: handles(model),
        }
    }
}

fn axis_ids(model: &Model) -> impl Iterator<Item = AxisId> + use<> {
    (0..model.axes.len()).map(AxisId::new)
}

/// The path of an axis that has a name.
pub(super) fn path(model: &Model, axis: AxisId) -> Option<String> {
    let axis = model.axis(axis);
    let name = axis.name.as_ref()?;
    Some(format!("{}.{name}", model.owner_of(axis)))
}

/// The axis by which a joint is seen, and moved: the one on the link that is nearer to the ground.
pub(super) fn axis_of_joint(model: &Model, joint: JointId) -> Option<AxisId> {
    let [a, b] = model.joint(joint).kind.axes()?;
    // A slot is seen where its pin is.
    let is_slot = model.link(model.axis(b).link).die.is_some();
    Some(model.seen_axis(if is_slot { b } else { a }))
}

fn wheels(model: &Model, pivots: &[Option<AxisId>]) -> Vec<Option<(JointId, usize)>> {
    let mut found = vec![None; model.links.len()];
    for (index, joint) in model.joints.iter().enumerate() {
        let (JointKind::Gear { a, b, .. } | JointKind::Belt { a, b, .. }) = joint.kind else {
            continue;
        };
        if [a, b].iter().all(|link| pivots[link.index()].is_some()) {
            for (side, link) in [a, b].into_iter().enumerate() {
                found[link.index()].get_or_insert((JointId::new(index), side));
            }
        }
    }
    found
}

fn handles(model: &Model) -> Vec<(Item, AxisId, HandleKind)> {
    let joints = model.declared_joints().filter_map(|joint| {
        let kind = match model.joint(joint).kind {
            JointKind::Revolute(..) => HandleKind::Pin,
            JointKind::Prismatic(..) => HandleKind::Slide,
            JointKind::Weld(..) => HandleKind::Weld,
            _ => return None,
        };
        let item = Item::Joint(model.joint(joint).name.clone());
        Some((item, axis_of_joint(model, joint)?, kind))
    });
    let axes = loose_axes(model).filter_map(|axis| {
        let kind = match model.axis(axis).kind {
            AxisKind::Point => HandleKind::Point,
            AxisKind::Line => HandleKind::Line,
        };
        Some((Item::Axis(path(model, axis)?), axis, kind))
    });
    joints.chain(axes).collect()
}

/// The points and lines that no joint has.
fn loose_axes(model: &Model) -> impl Iterator<Item = AxisId> {
    let mut is_used = vec![false; model.axes.len()];
    for joint in &model.joints {
        for axis in joint.kind.axes().into_iter().flatten() {
            is_used[axis.index()] = true;
            is_used[model.seen_axis(axis).index()] = true;
        }
    }
    axis_ids(model).filter(move |axis| !is_used[axis.index()])
}
