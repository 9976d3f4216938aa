//! The lines of a report about forces and traces.

use super::name;
use crate::compiled::ForcePrograms;
use crate::cost;
use crate::model::{Model, Precision, Trace};
use crate::program::Program;
use std::fmt::Write;

/// Masses, springs, dampers and loads, and what it costs to compute their effects.
pub(super) fn force_lines(
    text: &mut String,
    model: &Model,
    program: &Program,
    forced: &ForcePrograms,
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
        ("all forces", &forced.inverse_dynamics),
        ("inertia", &forced.inertia),
    ];
    for (what, derived) in programs {
        if let Some(derived) = derived {
            let more = cost::of_rates(program, derived);
            writeln!(text, "  effects   {what}: {more} more")?;
        }
    }
    if model.effects.force && forced.inverse_dynamics.is_none() {
        writeln!(
            text,
            "  reactions are not determined: joints hold links more than once"
        )?;
    }
    Ok(())
}

/// The length of a trace, and the memory that it takes.
pub(super) fn trace_line(model: &Model, trace: &Trace) -> String {
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
