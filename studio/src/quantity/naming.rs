//! The texts of measurands: `coupler.tip.x`, `velocity:b`, `transmission`.

use crate::failure::Failure;
use crate::text::quoted;
use mech_compiler::model::{JointId, JointKind, LinkId, Measurand, Model, Quantity};
use mech_compiler::plan::Plan;
use mech_compiler::syntax;

const TRANSMISSION: &str = "transmission";

/// What a text measures: of a point both parts, of `transmission` the angles of all dyads.
pub(crate) fn measurands(
    model: &Model,
    plan: &Plan,
    text: &str,
) -> Result<Vec<Measurand>, Failure> {
    const OF_ALL: Option<Quantity> = Some(Quantity::Transmission(None));
    let found = syntax::measurands(model, text)
        .map_err(|message| Failure::usage(format!("`{text}`: {}", message.text)))?;
    if found.iter().any(|one| one.quantity() == OF_ALL) {
        return transmissions(model, plan);
    }
    let mut measured = found.iter().flat_map(Measurand::measured);
    if measured.any(|one| one.quantity() == OF_ALL) {
        return Err(Failure::usage(format!(
            "`{text}`: every dyad has a transmission angle of its own; name one by its joint, as `transmission(b)`"
        )));
    }
    Ok(found)
}

/// What a text measures, if it is one number.
pub(crate) fn only_measurand(model: &Model, plan: &Plan, text: &str) -> Result<Measurand, Failure> {
    let found = measurands(model, plan, text)?;
    <[Measurand; 1]>::try_from(found).map(|[only]| only).map_err(|found| {
        let names = quoted(found.iter().map(|one| &one.name));
        Failure::usage(format!("`{text}` is several numbers, {names}; name one of them"))
    })
}

/// The coordinates of all joints that have one.
pub(crate) fn usual(model: &Model) -> Vec<Measurand> {
    let joints = model.declared_joints().filter(|&joint| has_coordinate(model, joint));
    let measurand = |joint: JointId| {
        let name = model.joint(joint).name.clone();
        Measurand::of(name, Quantity::Coordinate(joint))
    };
    joints.map(measurand).collect()
}

/// The transmission angles of all dyads, which are named by the joints of their unknowns.
pub(crate) fn transmissions(model: &Model, plan: &Plan) -> Result<Vec<Measurand>, Failure> {
    let angles = plan.loops().filter_map(|ring| {
        let joints = ring.unknowns();
        let mut names: Vec<&str> = Vec::new();
        for joint in &joints {
            let name = model.joint(*joint).name.as_str();
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let name = format!("{TRANSMISSION} of {}", names.join(" "));
        let angle = Quantity::Transmission(Some(*joints.first()?));
        Some(Measurand::of(name, angle))
    });
    let angles: Vec<Measurand> = angles.collect();
    if angles.is_empty() {
        return Err(Failure::usage(format!(
            "`{}` has no loop, so it has no transmission angle",
            model.name
        )));
    }
    Ok(angles)
}

/// A link, or the ground.
pub(crate) fn body_of(model: &Model, name: &str) -> Result<LinkId, Failure> {
    let is_ground = name == "ground";
    let found = is_ground.then_some(LinkId::GROUND).or_else(|| link_of(model, name));
    found.ok_or_else(|| {
        let links = model.declared_links().map(|link| &model.link(link).name);
        Failure::usage(format!(
            "`{}` has no link `{name}`; it has `ground`, {}",
            model.name,
            quoted(links)
        ))
    })
}

fn link_of(model: &Model, name: &str) -> Option<LinkId> {
    model.declared_links().find(|&link| model.link(link).name == name)
}

pub(super) fn has_coordinate(model: &Model, joint: JointId) -> bool {
    matches!(model.joint(joint).kind, JointKind::Revolute(..) | JointKind::Prismatic(..))
}
