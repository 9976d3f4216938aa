//! The gestures that remove items from a text, and leave the rest as it is.

use super::drawing::{Drawing, distance};
use super::{Gesture, Item};
use crate::edit::Command;
use crate::text::shortest;
use mech_compiler::model::{AxisId, JointId, Link, LinkId};
use std::collections::BTreeSet;

/// Takes out what is selected; none if nothing is.
pub(super) fn removal(selected: &BTreeSet<Item>, drawing: Option<&Drawing>) -> Option<Gesture> {
    let commands: Vec<Command> = selected.iter().map(Item::removal).collect();
    let title = match &commands[..] {
        [] => return None,
        [only] => only.title(),
        several => format!("remove {} things", several.len()),
    };
    let ends = drawing
        .into_iter()
        .flat_map(|drawing| ends_that_stay(selected, drawing));
    Some(Gesture::new(title, ends.chain(commands).collect()))
}

/// Points where links are joined by what is selected and nothing else: without it these are free ends.
fn ends_that_stay(selected: &BTreeSet<Item>, drawing: &Drawing) -> Vec<Command> {
    let model = &drawing.model;
    let is_gone = |link: LinkId| {
        let name = model.link(link).name.clone();
        selected.contains(&Item::Link(name))
    };
    let goes = |joint: &JointId| {
        let name = model.joint(*joint).name.clone();
        let (a, b) = model.ends(*joint);
        selected.contains(&Item::Joint(name)) || is_gone(a) || is_gone(b)
    };
    let (gone, kept): (Vec<JointId>, Vec<JointId>) = model.joint_ids().partition(goes);
    let axes = |joints: Vec<JointId>| {
        let axes = joints.into_iter();
        axes.filter_map(|joint| model.joint(joint).kind.axes())
            .flatten()
    };
    let kept: BTreeSet<AxisId> = axes(kept).collect();
    let is_there = |axis: &AxisId| kept.contains(axis) || drawing.path(*axis).is_some();
    let tolerance = 1e-9 * model.size();
    let mut found: Vec<(String, [f64; 2])> = Vec::new();
    for axis in axes(gone) {
        let (link, at) = (model.axis(axis).link, model.axis(axis).at);
        let Link { name, die, .. } = model.link(link);
        let mut others = drawing.axes_on(link).filter(is_there);
        let stays = others.any(|other| distance(model.axis(other).at, at) <= tolerance)
            || found
                .iter()
                .any(|(other, place)| other == name && distance(*place, at) <= tolerance);
        // The points of a part are declared in that part.
        let is_own = link != LinkId::GROUND && die.is_none() && !name.contains('.');
        if is_own && !is_gone(link) && !stays {
            found.push((name.clone(), at));
        }
    }
    let mut taken = BTreeSet::new();
    let ends = found.into_iter().map(|(link, at)| {
        let paths = (1_u32..).map(|number| format!("{link}.end{number}"));
        let mut free = paths.filter(|path| drawing.axis(path).is_none());
        let path = free.find(|path| taken.insert(path.clone()));
        Command::Axis {
            path: path.unwrap_or_default(),
            at: at.map(|part| shortest(part, tolerance)),
            along: None,
        }
    });
    ends.collect()
}
