//! Where links are drawn that have no place yet: as far as it goes, where their joints want them.

use super::drawing::{Pose, SCENE, apply};
use mech_compiler::model::{AxisId, JointKind, LinkId, Model};

/// The pose of each link: as known, or as its joints to those that are known want it, or that of the scene.
pub(super) fn placed(model: &Model, mut known: Vec<Option<Pose>>) -> Vec<Pose> {
    known.resize(model.links.len(), None);
    known[LinkId::GROUND.index()] = Some(SCENE);
    for link in model.link_ids().filter(|link| model.link(*link).drawn) {
        known[link.index()].get_or_insert(SCENE);
    }
    // Each round places one link at least, or is the last.
    while let Some((link, pose)) = next(model, &known) {
        known[link.index()] = Some(pose);
    }
    known
        .into_iter()
        .map(|pose| pose.unwrap_or(SCENE))
        .collect()
}

/// A link that a joint to a placed one can place.
fn next(model: &Model, known: &[Option<Pose>]) -> Option<(LinkId, Pose)> {
    model.joints.iter().find_map(|joint| {
        let [a, b] = joint.kind.axes()?;
        let link = |axis: AxisId| model.axis(axis).link;
        let [one, other] = [link(a), link(b)].map(|link| known[link.index()]);
        let turns = matches!(joint.kind, JointKind::Revolute(..));
        match (one, other) {
            (Some(pose), None) => Some((link(b), beside(model, (a, pose), b, turns))),
            (None, Some(pose)) => Some((link(a), beside(model, (b, pose), a, turns))),
            _ => None,
        }
    })
}

/// The pose of the link of an axis that coincides with one that is placed.
fn beside(model: &Model, (fixed, pose): (AxisId, Pose), axis: AxisId, turns: bool) -> Pose {
    let [x, y] = apply(pose, model.axis(fixed).at);
    let [cos, sin] = if turns {
        near(model, model.axis(axis).link)
    } else {
        turn(
            pose,
            model.axis(fixed).direction,
            model.axis(axis).direction,
        )
    };
    let [left, up] = apply([cos, sin, 0.0, 0.0], model.axis(axis).at);
    [cos, sin, x - left, y - up]
}

/// The angle near which a link was said to start, as a direction.
fn near(model: &Model, link: LinkId) -> [f64; 2] {
    let near = model.start.near.iter().find(|near| near.link == link);
    near.map_or([1.0, 0.0], |near| [near.angle.cos(), near.angle.sin()])
}

/// The turn that brings a direction of one link onto that of another.
fn turn([cos, sin, ..]: Pose, of: [f64; 2], onto: [f64; 2]) -> [f64; 2] {
    let [u, v] = apply([cos, sin, 0.0, 0.0], of);
    [u * onto[0] + v * onto[1], v * onto[0] - u * onto[1]]
}
