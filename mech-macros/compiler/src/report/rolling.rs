//! The report's lines about gears, belts, racks and cams.

use super::instances::alike;
use super::name;
use crate::bug::bug;
use crate::model::{JointKind, Model, Ratio};
use crate::plan::{Cam, Mesh, Plan, Rational, Source, Step, fraction};
use crate::structure::{Rolling, Structure};

/// The lines about what gears, belts, racks and cams couple.
pub(super) fn coupling_lines(model: &Model, structure: &Structure, plan: &Plan) -> Vec<String> {
    let rollings = structure.rollings.iter();
    let rollings: Vec<String> = rollings.map(|rolling| rolling_line(model, rolling)).collect();
    let moved = plan.steps.iter().filter_map(|step| match step {
        Step::Mesh(mesh) => Some(mesh_line(model, plan, mesh)),
        _ => None,
    });
    let moved: Vec<String> = moved.collect();
    let cams = plan.steps.iter().filter_map(|step| match step {
        Step::Cam(cam) => Some(cam_line(model, cam)),
        _ => None,
    });
    let cams: Vec<String> = cams.collect();
    let mut lines = Vec::new();
    lines.extend(freedoms(plan).map(|line| format!("freedoms  {line}")));
    for (what, of) in [("rolling", rollings), ("moved", moved), ("cam", cams)] {
        lines.extend(alike(&of).iter().map(|line| format!("{what:<9} {line}")));
    }
    lines
}

/// Counts the coordinates of the joints by what determines them; none where only motors and loops do.
fn freedoms(plan: &Plan) -> Option<String> {
    let count = |of: fn(&Step) -> usize| plan.steps.iter().map(of).sum::<usize>();
    let motors = count(|step| usize::from(matches!(step, Step::Drive(_))));
    let rolling = count(|step| usize::from(matches!(step, Step::Mesh(_))));
    let cams = count(|step| usize::from(matches!(step, Step::Cam(_))));
    let loops = count(|step| match step {
        Step::Close(closing) => closing.unknowns().len(),
        _ => 0,
    });
    if rolling + cams == 0 {
        return None;
    }
    let parts = [
        (motors, "by motors"),
        (rolling, "by gears, belts and racks"),
        (cams, "by cams"),
        (loops, "by loops"),
    ];
    let parts = parts.iter().filter(|(count, _)| *count > 0);
    let parts: Vec<String> = parts.map(|(count, by)| format!("{count} {by}")).collect();
    let all = motors + rolling + cams + loops;
    Some(format!("{all} of joints: {}", parts.join(", ")))
}

/// The links, the size and the carrier of a gear, belt or rack.
fn rolling_line(model: &Model, rolling: &Rolling) -> String {
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
    format!("{}: {a} and {b}, {size}, on {}", joint.name, name(model, rolling.carrier))
}

/// The factors of motors, angles and displacements in the coordinate of a joint that gears, belts or racks move.
fn mesh_line(model: &Model, plan: &Plan, mesh: &Mesh) -> String {
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
fn cam_line(model: &Model, cam: &Cam) -> String {
    let joint = model.joint(cam.by);
    let JointKind::Cam { shaft, follower, law } = joint.kind else {
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
