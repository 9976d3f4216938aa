//! The report: what the analysis found, in plain text, for the terminal, the docs and the gallery.

use crate::model::{JointId, JointKind, LinkId, Method, Model, Ratio};
use crate::plan::{ConnectionKind, Loop, Plan, Step};
use crate::structure::{Gear, Structure};
use std::fmt::Write;

/// The report of a coherent mechanism.
#[must_use]
pub fn report(model: &Model, structure: &Structure, plan: &Plan) -> String {
    let mut text = String::new();
    // Writing into a string does not fail.
    let _ = write(&mut text, model, structure, plan);
    text
}

fn write(text: &mut String, model: &Model, structure: &Structure, plan: &Plan) -> std::fmt::Result {
    let gears = structure.gears.len();
    let moving = model.links.len() - 1;
    let pairs = model.joints.len() - gears;
    let motors: Vec<JointId> = model.motors.iter().map(|motor| motor.joint).collect();
    writeln!(text, "{}", model.name)?;
    let meshes = if gears == 0 {
        String::new()
    } else {
        format!(" − {gears}")
    };
    writeln!(
        text,
        "  mobility  {} = 3·{moving} − 2·{pairs}{meshes}",
        structure.mobility
    )?;
    writeln!(text, "  motors    {}", joints(model, &motors))?;
    writeln!(text, "  trunk     {}", joints(model, &structure.trunk))?;
    writeln!(text, "  arms      {}", joints(model, &structure.arms))?;
    for gear in &structure.gears {
        writeln!(text, "  gear      {}", gear_line(model, gear))?;
    }
    for (index, ring) in plan.loops().enumerate() {
        writeln!(text, "  loop {:<4} {}", index + 1, loop_line(model, ring))?;
        writeln!(text, "            {}", needs_line(model, plan, ring))?;
    }
    writeln!(text, "  method    {}", method(model))
}

fn joints(model: &Model, ids: &[JointId]) -> String {
    if ids.is_empty() {
        return "none".to_owned();
    }
    ids.iter()
        .map(|&id| model.joint(id).name.as_str())
        .collect::<Vec<_>>()
        .join(" ")
}

fn name(model: &Model, link: LinkId) -> &str {
    &model.link(link).name
}

fn gear_line(model: &Model, gear: &Gear) -> String {
    let ratio = match gear.ratio {
        Ratio::Teeth(a, b) => format!("{a} : {b} teeth"),
        Ratio::Radii(a, b) => format!("radii {a} : {b}"),
    };
    let joint = &model.joint(gear.joint).name;
    let (a, b) = (name(model, gear.a.0), name(model, gear.b.0));
    format!(
        "{joint}: {a} and {b}, {ratio}, on {}",
        name(model, gear.carrier)
    )
}

fn loop_line(model: &Model, ring: &Loop) -> String {
    let unknowns = ring.ring.iter().map(|connection| {
        let kind = match connection.kind {
            ConnectionKind::Revolute => "angle",
            ConnectionKind::Prismatic => "way",
        };
        format!("{} ({kind})", model.joint(connection.joint).name)
    });
    let unknowns: Vec<String> = unknowns.collect();
    format!("level {}: unknowns {}", ring.level, unknowns.join(", "))
}

fn needs_line(model: &Model, plan: &Plan, ring: &Loop) -> String {
    let needs = match &ring.needs[..] {
        [] => drivers(model, plan, ring),
        [one] => format!("after loop {}", one + 1),
        several => format!(
            "after loops {}",
            several
                .iter()
                .map(|n| (n + 1).to_string())
                .collect::<Vec<_>>()
                .join(", ")
        ),
    };
    format!("joints {}; {needs}", joints(model, &ring.members))
}

/// What leads to a loop that needs no other: the motors and gears among its members.
fn drivers(model: &Model, plan: &Plan, ring: &Loop) -> String {
    let driven = plan.steps.iter().filter_map(|step| match step {
        Step::Drive(drive) => Some((drive.connection.joint, "motor", drive.connection.joint)),
        Step::Mesh(mesh) => Some((mesh.output.joint, "gear", mesh.gear)),
        Step::Close(_) => None,
    });
    let mut words: Vec<String> = driven
        .filter(|(joint, ..)| ring.members.contains(joint))
        .map(|(_, kind, by)| format!("{kind} {}", model.joint(by).name))
        .collect();
    words.dedup();
    if words.is_empty() {
        "rigid by itself".to_owned()
    } else {
        format!("driven by {}", words.join(", "))
    }
}

fn method(model: &Model) -> String {
    let loops = model
        .joints
        .iter()
        .any(|joint| !matches!(joint.kind, JointKind::Gear { .. }));
    match model.method {
        Method::Newton if loops => "Newton, until each loop closes to rounding".to_owned(),
        Method::Newton => "none needed".to_owned(),
        Method::NewtonSteps(1) => "Newton, one round a loop".to_owned(),
        Method::NewtonSteps(rounds) => format!("Newton, {rounds} rounds a loop"),
    }
}
