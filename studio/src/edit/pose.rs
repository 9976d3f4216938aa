//! Editing where the mechanism is seen, with its motors at other values than at the start.

use super::{Refusal, Scene};
use crate::document::Reading;
use crate::motion::{self, Mover, Setting};
use mech_compiler::Compiled;
use mech_compiler::model::{AxisId, LinkId, Model};

/// A place in the scene, carried back to the frame in which something is declared.
pub(super) fn carry_back(
    scene: &Scene,
    (path, axis): (&str, AxisId),
    [x, y]: [f64; 2],
    motors: &[(String, f64)],
) -> Result<[f64; 2], Refusal> {
    let reading = scene.reading()?;
    let Ok(compiled) = &reading.result else {
        return Err(Refusal::of("the mechanism does not move yet; edit it as it is declared"));
    };
    let machine = posed(&reading.model, compiled, motors)?;
    let link = link_of(&reading.model, path, axis)?;
    let Some([cos, sin, left, up]) = pose_of(compiled, &machine, link) else {
        return Err(Refusal::of(format!(
            "nothing shows where link `{}` is",
            reading.model.link(link).name
        )));
    };
    let [x, y] = [x - left, y - up];
    Ok([cos * x + sin * y, cos * y - sin * x])
}

/// Refuses an edit after which the mechanism cannot come to the pose at which it was made.
pub(super) fn judge(
    reading: &Reading,
    path: &str,
    motors: Option<&[(String, f64)]>,
) -> Result<(), Refusal> {
    let Some(motors) = motors else {
        return Ok(());
    };
    let Ok(compiled) = &reading.result else {
        return Err(Refusal::of(format!(
            "with `{path}` there the mechanism would not move any more"
        )));
    };
    posed(&reading.model, compiled, motors).map(drop)
}

/// A mechanism with its motors at these values; others stand as at the start. What is written into texts is not rounded.
fn posed<'c>(
    model: &Model,
    compiled: &'c Compiled,
    motors: &[(String, f64)],
) -> Result<Mover<'c>, Refusal> {
    if motors.iter().any(|(_, value)| !value.is_finite()) {
        return Err(Refusal::of("the value of a motor is finite"));
    }
    let settings = motors.iter().cloned().map(Setting::from);
    let settings: Vec<Setting> = settings.collect();
    Ok(motion::posed(Mover::exact(compiled), model, compiled, &settings)?)
}

/// The link in whose frame something is seen to move.
fn link_of(model: &Model, path: &str, axis: AxisId) -> Result<LinkId, Refusal> {
    let joint = model.joints.iter().position(|joint| joint.name == path);
    let is_axis = model.axis(axis).name.is_some();
    let Some(joint) = joint.filter(|_| !is_axis) else {
        return Ok(model.axis(axis).link);
    };
    let (a, b) = model.ends(mech_compiler::model::JointId::new(joint));
    if a == LinkId::GROUND || b == LinkId::GROUND {
        return Ok(LinkId::GROUND);
    }
    Err(Refusal::of(format!(
        "joint `{path}` was drawn on two links that move, which have turned apart; move it at the start"
    )))
}

fn pose_of(compiled: &Compiled, machine: &Mover<'_>, link: LinkId) -> Option<[f64; 4]> {
    if link == LinkId::GROUND {
        return Some([1.0, 0.0, 0.0, 0.0]);
    }
    let place = compiled.program.place_of(link)?;
    machine.position().poses.get(place).copied()
}

/// The poses of all links, as far as they are shown, with the motors at these values.
pub(super) fn poses(
    model: &Model,
    compiled: &Compiled,
    motors: &[(String, f64)],
) -> Result<Vec<Option<[f64; 4]>>, Refusal> {
    let machine = posed(model, compiled, motors)?;
    let links = model.link_ids();
    Ok(links.map(|link| pose_of(compiled, &machine, link)).collect())
}

pub(super) fn start_of(compiled: &Compiled, link: LinkId) -> Option<[f64; 4]> {
    pose_of(compiled, &Mover::exact(compiled), link)
}
