//! The results of the analysis as plain text, for the terminal, the documentation and the gallery.

mod contact;
mod effects;
mod instances;
mod jump;
mod loops;
mod rolling;

use crate::compiled::Compiled;
use crate::cost;
use crate::model::{Joint, JointId, JointKind, LinkId, Model};
use crate::motion::near_miss::NearMiss;
use crate::structure::Structure;
use effects::{force_lines, trace_line};
use instances::{is_described, joint_names, part_lines};
use loops::{accuracy, loop_line, method, method_line, needs_line, omissions};
use rolling::coupling_lines;
use std::fmt::Write;

/// The report of a coherent mechanism.
pub(crate) fn report(model: &Model, compiled: &Compiled) -> String {
    let mut text = String::new();
    // Writing into a string does not fail.
    let _ = write(&mut text, model, compiled);
    text
}

/// Returns the notes on how a mechanism moves.
pub(crate) fn notes(model: &Model, compiled: &Compiled) -> Vec<String> {
    let near = near_misses(model, compiled).into_iter();
    let undercut = contact::notes(model, compiled);
    near.chain(jump::notes(model)).chain(undercut).collect()
}

fn write(text: &mut String, model: &Model, compiled: &Compiled) -> std::fmt::Result {
    let Compiled {
        structure,
        plan,
        program,
        moving,
        forced,
        timing,
        sensitive,
        loops,
        prediction,
        saved,
        ..
    } = compiled;
    let motors: Vec<JointId> = model.motors.iter().map(|motor| motor.joint).collect();
    writeln!(text, "{}", model.name)?;
    writeln!(text, "  mobility  {}", mobility(model, structure))?;
    writeln!(text, "  motors    {}", joints(model, &motors))?;
    for (motor, law) in model.lawful_motors() {
        let joint = model.joint(model.motor(motor).joint);
        writeln!(text, "  law       {} = {}", joint.name, law.written)?;
    }
    let params = model.params.all().iter();
    let params: Vec<String> =
        params.map(|param| format!("`{}` = {}", param.name, param.value)).collect();
    if !params.is_empty() {
        writeln!(text, "  params    {}", params.join(", "))?;
    }
    writeln!(text, "  trunk     {}", joints(model, &structure.trunk))?;
    writeln!(text, "  arms      {}", joints(model, &structure.arms))?;
    if !structure.redundant.is_empty() {
        writeln!(text, "  redundant {}", joints(model, &structure.redundant))?;
    }
    for line in coupling_lines(model, structure, plan) {
        writeln!(text, "  {line}")?;
    }
    for roller in &model.rollers {
        if let Some(line) = contact::line(model, compiled, roller.cam) {
            writeln!(text, "            {line}")?;
        }
    }
    for line in part_lines(model, plan, loops) {
        writeln!(text, "  part      {line}")?;
    }
    for (index, closing) in plan.loops().enumerate() {
        if is_described(model, closing) {
            continue;
        }
        writeln!(text, "  loop {:<4} {}", index + 1, loop_line(model, closing))?;
        writeln!(text, "            {}", needs_line(model, plan, closing))?;
        if let Some(solved) = loops.iter().find(|solved| solved.number == index) {
            writeln!(text, "            {}", method_line(solved))?;
        }
    }
    for note in &compiled.notes {
        writeln!(text, "  note      {note}")?;
    }
    writeln!(text, "  method    {}", method(model, program))?;
    if let Some(prediction) = prediction {
        writeln!(text, "  accuracy  {}", accuracy(model, prediction))?;
    }
    if let Some(saved) = saved {
        writeln!(text, "  left out  {}: {saved}", omissions(model, plan, program))?;
    }
    writeln!(text, "  cost      {}", cost::of_program(program))?;
    if let Some(moving) = moving {
        let kinds =
            if model.effects.acceleration { "velocity and acceleration" } else { "velocity" };
        let more = cost::of_rates(program, moving);
        writeln!(text, "  effects   {kinds}: {more} more")?;
    }
    if let Some(timing) = timing {
        let more = cost::of_program(&timing.program);
        writeln!(text, "  at time   {more} more")?;
    }
    inverse_lines(text, model, compiled)?;
    for trace in &model.traces {
        writeln!(text, "  trace     {}", trace_line(model, trace))?;
    }
    if let Some(sensitive) = sensitive {
        let more = cost::of_program(sensitive);
        writeln!(text, "  effects   sensitivity to the params: {more}")?;
    }
    if model.effects.needs_actions() {
        force_lines(text, model, program, forced)?;
    }
    Ok(())
}

/// The mobility by counting, with the degrees of freedom that each kind of joint removes.
fn mobility(model: &Model, structure: &Structure) -> String {
    let count =
        |wanted: fn(&Joint) -> bool| model.joints.iter().filter(|joint| wanted(joint)).count();
    let slots = count(|joint| joint.hidden);
    let pairs =
        count(|joint| matches!(joint.kind, JointKind::Revolute(..) | JointKind::Prismatic(..)))
            - 2 * slots;
    let welds = count(|joint| matches!(joint.kind, JointKind::Weld(..)));
    let rolls = count(|joint| joint.kind.ties());
    let mut text =
        format!("{} = 3·{} − 2·{pairs}", structure.mobility, model.declared_links().count());
    for (what, times) in [("3·", welds), ("", slots + rolls)] {
        if times > 0 {
            text += &format!(" − {what}{times}");
        }
    }
    text
}

/// The names of joints.
fn joints(model: &Model, ids: &[JointId]) -> String {
    if ids.is_empty() {
        return "none".to_owned();
    }
    joint_names(model, ids).join(" ")
}

/// A noun with names after it, in the plural if there are several; none if there are none.
fn plural(noun: &str, count: usize, names: &str) -> Option<String> {
    match count {
        0 => None,
        1 => Some(format!("{noun} {names}")),
        _ => Some(format!("{noun}s {names}")),
    }
}

/// The name of a link.
fn name(model: &Model, link: LinkId) -> &str {
    &model.link(link).name
}

/// Writes what is led, by which motors, and how the loops are solved; nothing if no motors follow.
fn inverse_lines(text: &mut String, model: &Model, compiled: &Compiled) -> std::fmt::Result {
    let Some(inverse) = &model.inverse else {
        return Ok(());
    };
    let motors = inverse.motors.iter().map(|motor| model.motor(*motor).joint);
    let motors: Vec<JointId> = motors.collect();
    let (what, motors) = (inverse.name(model), joints(model, &motors));
    write!(text, "  follow    {what} is led, {motors} follow")?;
    let Some(inverted) = &compiled.inverse else {
        return writeln!(text, ", and go as little as they can");
    };
    let more = cost::of_program(&inverted.compiled.program);
    writeln!(text, ": {more} more")?;
    if !inverse.trajectory.is_empty() {
        let laws = inverse.trajectory.iter().map(|law| model.law(*law));
        let laws: Vec<&str> = laws.map(|law| law.written.as_str()).collect();
        writeln!(text, "            along ({})", laws.join(", "))?;
    }
    for solved in &inverted.compiled.loops {
        writeln!(text, "            {}", method_line(solved))?;
    }
    Ok(())
}

/// More notes than these say nothing new.
const MOST_NEAR: usize = 8;

/// Returns the notes on loops that come near change points.
fn near_misses(model: &Model, compiled: &Compiled) -> Vec<String> {
    let all = &compiled.near_misses;
    let mut notes: Vec<String> =
        all.iter().take(MOST_NEAR).map(|miss| near_miss(model, miss)).collect();
    if all.len() > MOST_NEAR {
        notes.push(format!("so do {} other loops", all.len() - MOST_NEAR));
    }
    notes
}

/// ``the loop `b`, `c` passes within 5e-11 of a change point at a = -70.53 deg``.
fn near_miss(model: &Model, miss: &NearMiss) -> String {
    let NearMiss { place, motor, at, distance, passes, .. } = miss;
    let joint = model.joint(model.motor(*motor).joint);
    let at = match joint.kind {
        JointKind::Revolute(..) => format!("{:.2} deg", at.to_degrees()),
        _ => format!("{at:.4}"),
    };
    let verb = if *passes { "passes" } else { "stops" };
    format!(
        "the loop {place} {verb} within {distance:.0e} of a change point at {} = {at}",
        joint.name
    )
}
