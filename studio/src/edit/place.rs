//! Points, lines and joints that are moved.

use super::{Change, Refusal, Scene, pose, solve};
use mech_compiler::model::{AxisId, Model};

/// Moves a point, the origin of a line, or a joint that is placed in the drawing.
pub(super) fn shift(
    scene: &Scene,
    path: &str,
    to: [f64; 2],
    motors: Option<&[(String, f64)]>,
) -> Result<Change, Refusal> {
    let mut change = Change::default();
    change.place = Some(shift_too(scene, path, to, motors, &mut change)?);
    Ok(change)
}

/// Moves one more thing, beyond what the change already moves. Returns its place in the frame in which it is declared.
pub(super) fn shift_too(
    scene: &Scene,
    path: &str,
    to: [f64; 2],
    motors: Option<&[(String, f64)]>,
    change: &mut Change,
) -> Result<[f64; 2], Refusal> {
    if !to.iter().all(|part| part.is_finite()) {
        return Err(Refusal::of("a place has two finite numbers"));
    }
    let axis = find(scene, path)?;
    let to = match motors {
        Some(motors) => pose::carry_back(scene, (path, axis), to, motors)?,
        None => to,
    };
    for (index, role) in ["x", "y"].into_iter().enumerate() {
        let Some(number) = scene.listing.number(path, role) else {
            return Err(unknown(scene, path));
        };
        let read = |model: &Model| Some(model.axis(axis_of(model, path)?).at[index]);
        let goal = solve::Goal {
            what: &format!("{role} of `{path}`"),
            number,
            value: to[index],
            read: &read,
        };
        solve::reach(scene, &goal, change)?;
    }
    Ok(to)
}

/// The axis of this path, which has a place of its own.
pub(super) fn find(scene: &Scene, path: &str) -> Result<AxisId, Refusal> {
    let is_placed = scene.listing.number(path, "x").is_some();
    let axis = axis_of(&scene.model, path).filter(|_| is_placed);
    axis.ok_or_else(|| unknown(scene, path))
}

/// Refuses a text in which what was moved is not where it should be: a constant may stand in both coordinates.
pub(super) fn judge(after: &Model, path: &str, to: [f64; 2]) -> Result<(), Refusal> {
    let found = axis_of(after, path).map(|axis| after.axis(axis).at);
    let is_there = |found: [f64; 2]| found.iter().zip(to).all(|(a, b)| solve::is_near(*a, b));
    if found.is_some_and(is_there) {
        return Ok(());
    }
    Err(Refusal::of(format!(
        "both coordinates of `{path}` depend on the same number, which cannot give ({}, {})",
        to[0], to[1]
    )))
}

/// Why something cannot be moved.
fn unknown(scene: &Scene, path: &str) -> Refusal {
    let is_joint = scene.model.joints.iter().any(|joint| joint.name == path);
    let is_link = scene.model.links.iter().any(|link| link.name == path);
    let (part, inner) = scene.listing.resolve(path, None);
    Refusal::of(match part {
        Some(part) if scene.listing.number(&format!("{part}.{inner}"), "x").is_some() => {
            format!(
                "`{inner}` is fixed by part `{part}`, for all that use it; set `x` and `y` of `{part}.{inner}`"
            )
        }
        Some(part) => format!("`{inner}` is fixed by part `{part}`, for all that use it"),
        None if scene.listing.number(path, "x").is_some() => {
            format!("`{path}` is in the frame of its part; set its `x` and `y`")
        }
        None if is_joint => {
            format!("joint `{path}` has no place of its own; move the points that it joins")
        }
        None if is_link => format!("link `{path}` is placed by its joints; move a point of it"),
        None => format!("there is no point, line or joint `{path}` in this text"),
    })
}

/// The axis of this path, or the first of a joint.
pub(super) fn axis_of(model: &Model, path: &str) -> Option<AxisId> {
    let is_it = |axis: &mech_compiler::model::Axis| {
        let name = axis.name.as_deref();
        let link = path.rsplit_once('.').filter(|(_, last)| Some(*last) == name);
        axis.port.is_none() && link.is_some_and(|(link, _)| model.link(axis.link).name == link)
    };
    if let Some(index) = model.axes.iter().position(is_it) {
        return Some(AxisId::new(index));
    }
    let joint = model.joints.iter().find(|joint| joint.name == path)?;
    Some(joint.kind.axes()?[0])
}
