//! The report's lines about forces and traces.

use super::{name, plural};
use crate::compiled::ForcePrograms;
use crate::cost;
use crate::model::{Model, Precision, Trace};
use crate::program::Program;
use std::fmt::Write;

/// Writes masses, springs, dampers and loads, and the costs of computing their effects.
pub(super) fn force_lines(
    text: &mut String,
    model: &Model,
    program: &Program,
    forced: &ForcePrograms,
) -> std::fmt::Result {
    let masses = model.links.iter().filter_map(|link| link.mass);
    let (count, mass) = masses.fold((0, 0.0), |(count, sum), mass| (count + 1, sum + mass.mass));
    let actions = &model.actions;
    let mut parts =
        vec![format!("{count} of {} links weigh {mass:.6}", model.declared_links().count())];
    if actions.gravity.is_some() {
        parts.push("gravity".to_owned());
    }
    let springs = actions.springs.iter().map(|spring| spring.name.as_str());
    let dampers = actions.dampers.iter().map(|damper| damper.name.as_str());
    let loads = actions.loads.iter().map(|load| load.name.as_str());
    let all: [(&str, Vec<&str>); 3] =
        [("spring", springs.collect()), ("damper", dampers.collect()), ("load", loads.collect())];
    for (noun, names) in all {
        parts.extend(plural(noun, names.len(), &names.join(", ")));
    }
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
        writeln!(text, "  reactions are not determined: joints hold links more than once")?;
    }
    Ok(())
}

/// The length of a trace, and its memory in bytes.
pub(super) fn trace_line(model: &Model, trace: &Trace) -> String {
    let axis = model.axis(trace.point);
    let bytes = match model.precision {
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
        trace.length * 2 * bytes
    )
}
