//! The report: what the analysis found, in plain text, for the terminal, the docs and the gallery.

use crate::Forced;
use crate::accuracy::{Prediction, Solved};
use crate::bug::bug;
use crate::cost::{self, Cost};
use crate::model::{Joint, JointId, JointKind, LinkId, Method, Model, Precision, Ratio, Trace};
use crate::plan::{Cam, ConnectionKind, Loop, Mesh, Plan, Rational, Source, Step};
use crate::program::{self, Program, Timing};
use crate::structure::{Rolling, Structure};
use num_traits::ToPrimitive as _;
use std::fmt::Write;

/// What was found about a program.
#[derive(Clone, Copy, Debug)]
pub struct Found<'f> {
    /// The operations that move it.
    pub program: &'f Program,
    /// The same and those that go on to rates, if these were asked for.
    pub moving: Option<&'f Program>,
    /// The same and those that go on to forces, as far as these were asked for.
    pub forced: &'f Forced,
    /// The laws of the motors, if any has one.
    pub timing: Option<&'f Timing>,
    /// Those that tell how everything follows the params, if that was asked for.
    pub sensitive: Option<&'f Program>,
    /// How its loops are solved.
    pub loops: &'f [Solved],
    /// How exact it will be, if that was predicted.
    pub prediction: Option<&'f Prediction>,
    /// What is saved where only what is shown is computed.
    pub saved: Option<Cost>,
}

/// The report of a coherent mechanism.
#[must_use]
pub fn report(model: &Model, structure: &Structure, plan: &Plan, found: Found<'_>) -> String {
    let mut text = String::new();
    // Writing into a string does not fail.
    let _ = write(&mut text, model, structure, plan, found);
    text
}

fn write(
    text: &mut String,
    model: &Model,
    structure: &Structure,
    plan: &Plan,
    found: Found<'_>,
) -> std::fmt::Result {
    let Found {
        program,
        moving,
        forced,
        timing,
        sensitive,
        loops,
        prediction,
        saved,
    } = found;
    let motors: Vec<JointId> = model.motors.iter().map(|motor| motor.joint).collect();
    writeln!(text, "{}", model.name)?;
    writeln!(text, "  mobility  {}", mobility(model, structure))?;
    writeln!(text, "  motors    {}", joints(model, &motors))?;
    for (motor, law) in model.lawful_motors() {
        let joint = model.joint(model.motor(motor).joint);
        writeln!(text, "  law       {} = {}", joint.name, law.written)?;
    }
    let params = model.params.all().iter();
    let params: Vec<String> = params
        .map(|param| format!("`{}` = {}", param.name, param.value))
        .collect();
    if !params.is_empty() {
        writeln!(text, "  params    {}", params.join(", "))?;
    }
    writeln!(text, "  trunk     {}", joints(model, &structure.trunk))?;
    writeln!(text, "  arms      {}", joints(model, &structure.arms))?;
    if !structure.redundant.is_empty() {
        writeln!(text, "  redundant {}", joints(model, &structure.redundant))?;
    }
    for rolling in &structure.rollings {
        writeln!(text, "  rolling   {}", rolling_line(model, rolling))?;
    }
    for mesh in plan.steps.iter().filter_map(|step| {
        if let Step::Mesh(mesh) = step {
            Some(mesh)
        } else {
            None
        }
    }) {
        writeln!(text, "  moved     {}", mesh_line(model, plan, mesh))?;
    }
    for step in &plan.steps {
        if let Step::Cam(cam) = step {
            writeln!(text, "  cam       {}", cam_line(model, cam))?;
        }
    }
    for (index, closing) in plan.loops().enumerate() {
        writeln!(
            text,
            "  loop {:<4} {}",
            index + 1,
            loop_line(model, closing)
        )?;
        writeln!(text, "            {}", needs_line(model, plan, closing))?;
        if let Some(solved) = loops.iter().find(|solved| solved.number == index) {
            writeln!(text, "            {}", solved_line(solved))?;
        }
    }
    writeln!(text, "  method    {}", method(model, program))?;
    if let Some(prediction) = prediction {
        writeln!(text, "  accuracy  {}", accuracy(model, prediction))?;
    }
    if let Some(saved) = saved {
        writeln!(
            text,
            "  left out  {}: {saved}",
            left_out(model, plan, program)
        )?;
    }
    writeln!(text, "  cost      {}", cost::of_program(program))?;
    if let Some(moving) = moving {
        let kinds = if model.effects.acceleration {
            "velocity and acceleration"
        } else {
            "velocity"
        };
        let more = cost::of_rates(program, moving);
        writeln!(text, "  effects   {kinds}: {more} more")?;
    }
    if let Some(timing) = timing {
        let more = cost::of_program(&timing.program);
        writeln!(text, "  at time   {more} more")?;
    }
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

/// What acts, and what it costs to find what that does.
fn force_lines(
    text: &mut String,
    model: &Model,
    program: &Program,
    forced: &Forced,
) -> std::fmt::Result {
    let masses = model.links.iter().filter_map(|link| link.mass);
    let (count, mass) = masses.fold((0, 0.0), |(count, sum), mass| (count + 1, sum + mass.mass));
    let actions = &model.actions;
    let mut parts = vec![format!(
        "{count} of {} links weigh {mass:.6}",
        model.declared_links().count()
    )];
    if actions.gravity.is_some() {
        parts.push("gravity".to_owned());
    }
    let mut named = |what: &str, names: Vec<&str>| {
        if !names.is_empty() {
            let ending = if names.len() == 1 { "" } else { "s" };
            parts.push(format!("{what}{ending} {}", names.join(", ")));
        }
    };
    named(
        "spring",
        actions
            .springs
            .iter()
            .map(|one| one.name.as_str())
            .collect(),
    );
    named(
        "damper",
        actions
            .dampers
            .iter()
            .map(|one| one.name.as_str())
            .collect(),
    );
    named(
        "load",
        actions.loads.iter().map(|one| one.name.as_str()).collect(),
    );
    writeln!(text, "  acting    {}", parts.join("; "))?;
    let programs = [
        ("torques at rest", &forced.holding),
        ("all forces", &forced.acting),
        ("inertia", &forced.inertia),
    ];
    for (what, further) in programs {
        if let Some(further) = further {
            let more = cost::of_rates(program, further);
            writeln!(text, "  effects   {what}: {more} more")?;
        }
    }
    if model.effects.force && forced.acting.is_none() {
        writeln!(
            text,
            "  reactions are not determined: joints hold links more than once"
        )?;
    }
    Ok(())
}

/// How much of a path is kept.
fn trace_line(model: &Model, trace: &Trace) -> String {
    let axis = model.axis(trace.point);
    let number = match model.precision {
        Precision::F32 => 4,
        Precision::F64 => 8,
    };
    let places = match trace.length {
        1 => "place".to_owned(),
        length => format!("{length} places"),
    };
    format!(
        "{}.{}: the last {places}, {} bytes",
        name(model, axis.link),
        axis.own_name(),
        trace.length * 2 * number
    )
}

/// What nothing that is shown depends on.
fn left_out(model: &Model, plan: &Plan, program: &Program) -> String {
    let solved = program.solved_loops();
    let needed = program::needed(model, plan, &program.stored);
    let idle = (0..plan.loops().count()).filter(|number| !solved.contains(number));
    let loops: Vec<String> = idle.map(|number| (number + 1).to_string()).collect();
    let idle_arms = plan.steps.iter().zip(&needed.steps);
    let idle_arms = idle_arms.filter(|(step, needed)| !**needed && !matches!(step, Step::Close(_)));
    let mut arms: Vec<JointId> = idle_arms
        .flat_map(|(step, _)| step.connections())
        .map(|connection| connection.joint)
        .collect();
    arms.sort_unstable();
    let mut parts = Vec::new();
    match &loops[..] {
        [] => {}
        [one] => parts.push(format!("loop {one}")),
        several => parts.push(format!("loops {}", several.join(", "))),
    }
    match &arms[..] {
        [] => {}
        [one] => parts.push(format!("joint {}", joints(model, &[*one]))),
        several => parts.push(format!("joints {}", joints(model, several))),
    }
    if parts.is_empty() {
        parts.push("poses".to_owned());
    }
    parts.join(" and ")
}

/// How a loop is solved, and what that costs.
fn solved_line(solved: &Solved) -> String {
    let error = match solved.error {
        None => String::new(),
        Some(error) if error.is_finite() => format!(", predicted error {error:.1e}"),
        Some(_) => ", may stop for no reason but its method".to_owned(),
    };
    format!("{}{error}: {}", solved.method, solved.cost)
}

/// What was wished, and what is to be expected.
fn accuracy(model: &Model, prediction: &Prediction) -> String {
    let error = match prediction.error {
        error if error.is_finite() => format!("{error:.1e} predicted"),
        _ => "not bounded by the declared steps".to_owned(),
    };
    match model.accuracy {
        Some(accuracy) => format!("{error}, {accuracy:e} wanted"),
        None => error,
    }
}

/// The count, with what each kind of joint takes.
fn mobility(model: &Model, structure: &Structure) -> String {
    let count =
        |wanted: fn(&Joint) -> bool| model.joints.iter().filter(|joint| wanted(joint)).count();
    let slots = count(|joint| joint.hidden);
    let pairs = count(|joint| {
        matches!(
            joint.kind,
            JointKind::Revolute(..) | JointKind::Prismatic(..)
        )
    }) - 2 * slots;
    let welds = count(|joint| matches!(joint.kind, JointKind::Weld(..)));
    let rolls = count(|joint| joint.kind.ties());
    let mut text = format!(
        "{} = 3·{} − 2·{pairs}",
        structure.mobility,
        model.declared_links().count()
    );
    for (what, times) in [("3·", welds), ("", slots + rolls)] {
        if times > 0 {
            text += &format!(" − {what}{times}");
        }
    }
    text
}

fn joints(model: &Model, ids: &[JointId]) -> String {
    if ids.is_empty() {
        return "none".to_owned();
    }
    let mut names: Vec<&str> = ids
        .iter()
        .map(|&id| model.joint(id).name.as_str())
        .collect();
    // A slot is two joints of one name.
    names.dedup();
    names.join(" ")
}

fn name(model: &Model, link: LinkId) -> &str {
    &model.link(link).name
}

fn rolling_line(model: &Model, rolling: &Rolling) -> String {
    let joint = model.joint(rolling.joint);
    let size = match joint.kind {
        JointKind::Gear {
            ratio: Ratio::Teeth(a, b),
            ..
        } => format!("{a} : {b} teeth"),
        JointKind::Belt {
            ratio: Ratio::Teeth(a, b),
            ..
        } => format!("belt {a} : {b}"),
        JointKind::Gear {
            ratio: Ratio::Radii(a, b),
            ..
        } => format!("radii {a} : {b}"),
        JointKind::Belt {
            ratio: Ratio::Radii(a, b),
            ..
        } => format!("belt {a} : {b}"),
        JointKind::Rack { radius, .. } => format!("rack, radius {radius}"),
        kind => bug!("{kind:?} is told as something that rolls"),
    };
    let [a, b] = rolling.ends.map(|(end, _)| name(model, end.link()));
    format!(
        "{}: {a} and {b}, {size}, on {}",
        joint.name,
        name(model, rolling.carrier)
    )
}

/// A ratio as a fraction; where that comes from a pitch radius and is long, as a decimal number.
fn fraction(part: &Rational) -> String {
    /// No wheel has more teeth.
    const MOST: i64 = 100_000;
    let is_short = |whole: Option<i64>| whole.is_some_and(|whole| whole.abs() <= MOST);
    match part.to_f64() {
        Some(value) if !(is_short(part.numer().to_i64()) && is_short(part.denom().to_i64())) => {
            format!("{value}")
        }
        _ => part.to_string(),
    }
}

/// What a joint that rolling moves is moved by.
fn mesh_line(model: &Model, plan: &Plan, mesh: &Mesh) -> String {
    let part = |(source, part): &(usize, Rational)| {
        let source = match plan.sources[*source] {
            Source::Motor(motor) => model.joint(model.motor(motor).joint).name.clone(),
            Source::Angle { from, to } => {
                format!("angle of {} on {}", name(model, to), name(model, from))
            }
            Source::Way(joint) => model.joint(joint).name.clone(),
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

/// What a cam says.
fn cam_line(model: &Model, cam: &Cam) -> String {
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

fn loop_line(model: &Model, closing: &Loop) -> String {
    let unknowns = closing.connections().map(|connection| {
        let kind = match connection.kind {
            ConnectionKind::Revolute => "angle",
            ConnectionKind::Prismatic => "way",
        };
        format!("{} ({kind})", model.joint(connection.joint).name)
    });
    let unknowns: Vec<String> = unknowns.collect();
    let coupled = if closing.is_coupled() {
        format!("{} rings together, ", closing.rings.len())
    } else {
        String::new()
    };
    let tied = match closing.ties.len() {
        0 => String::new(),
        ties => format!(", {ties} tied by rolling"),
    };
    format!(
        "level {}: {coupled}unknowns {}{tied}",
        closing.level,
        unknowns.join(", ")
    )
}

fn needs_line(model: &Model, plan: &Plan, closing: &Loop) -> String {
    let needs = match &closing.needs[..] {
        [] => drivers(model, plan, closing),
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
    format!("joints {}; {needs}", joints(model, &closing.members))
}

/// What leads to a loop that needs no other: the motors and gears among its members.
fn drivers(model: &Model, plan: &Plan, closing: &Loop) -> String {
    let driven = plan.steps.iter().filter_map(|step| match step {
        Step::Drive(drive) => Some((drive.connection.joint, "motor", drive.connection.joint)),
        Step::Mesh(mesh) => Some((mesh.connection.joint, "rolling", mesh.by)),
        Step::Cam(cam) => Some((cam.connection.joint, "cam", cam.by)),
        Step::Weld(_) | Step::Close(_) => None,
    });
    let mut words: Vec<String> = driven
        .filter(|(joint, ..)| closing.members.contains(joint))
        .map(|(_, kind, by)| format!("{kind} {}", model.joint(by).name))
        .collect();
    words.dedup();
    if words.is_empty() {
        "rigid by itself".to_owned()
    } else {
        format!("driven by {}", words.join(", "))
    }
}

fn method(model: &Model, program: &Program) -> String {
    match (model.method, model.accuracy) {
        _ if !program.has_loops() => "none needed".to_owned(),
        (None, Some(_)) => "the cheapest that is accurate enough".to_owned(),
        (None | Some(Method::Exact), _) => "exact".to_owned(),
        (Some(Method::Newton), _) => "Newton, until each loop closes to rounding".to_owned(),
        (Some(Method::Linear), _) => "linear".to_owned(),
        (Some(Method::NewtonSteps(1)), _) => "Newton, one round a loop".to_owned(),
        (Some(Method::NewtonSteps(rounds)), _) => format!("Newton, {rounds} rounds a loop"),
    }
}
