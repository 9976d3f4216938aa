//! The report's lines about gears, belts, racks and cams.

use super::name;
use crate::bug::bug;
use crate::model::{JointKind, Model, Ratio};
use crate::plan::{Cam, Mesh, Plan, Rational, Source, fraction};
use crate::structure::Rolling;

/// The links, the size and the carrier of a gear, belt or rack.
pub(super) fn rolling_line(model: &Model, rolling: &Rolling) -> String {
    let joint = model.joint(rolling.joint);
    let size = match joint.kind {
        JointKind::Gear { ratio, .. } => match ratio {
            Ratio::Teeth(a, b) => format!("{a} : {b} teeth"),
            Ratio::Radii(a, b) => format!("radii {a} : {b}"),
        },
        JointKind::Belt { ratio, .. } => match ratio {
            Ratio::Teeth(a, b) => format!("belt {a} : {b}"),
            Ratio::Radii(a, b) => format!("belt {a} : {b}"),
        },
        JointKind::Rack { radius, .. } => format!("rack, radius {radius}"),
        kind => bug!("{kind:?} is reported as something that rolls"),
    };
    let [a, b] = rolling.ends.map(|(end, _)| name(model, end.link()));
    format!(
        "{}: {a} and {b}, {size}, on {}",
        joint.name,
        name(model, rolling.carrier)
    )
}

/// The factors of motors, angles and displacements in the coordinate of a joint that gears, belts or racks move.
pub(super) fn mesh_line(model: &Model, plan: &Plan, mesh: &Mesh) -> String {
    let part = |(source, part): &(usize, Rational)| {
        let source = match plan.sources[*source] {
            Source::Motor(motor) => model.joint(model.motor(motor).joint).name.clone(),
            Source::Angle { from, to } => {
                format!("angle of {} on {}", name(model, to), name(model, from))
            }
            Source::Displacement(joint) => model.joint(joint).name.clone(),
        };
        format!("{} · {source}", fraction(part))
    };
    let parts: Vec<String> = mesh.parts.iter().map(part).collect();
    let moved = &model.joint(mesh.connection.joint).name;
    if parts.is_empty() {
        format!("{moved} stands still")
    } else {
        format!("{moved} by {}", parts.join(" + "))
    }
}

/// The joints of a cam, and its law.
pub(super) fn cam_line(model: &Model, cam: &Cam) -> String {
    let joint = model.joint(cam.by);
    let JointKind::Cam {
        shaft,
        follower,
        law,
    } = joint.kind
    else {
        return String::new();
    };
    format!(
        "{}: {} = {}, q the coordinate of {}",
        joint.name,
        model.joint(follower).name,
        model.law(law).written,
        model.joint(shaft).name
    )
}
