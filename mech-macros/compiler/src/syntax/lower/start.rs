//! The statement `start`: how the mechanism is assembled.

use super::angle::is_degrees_perhaps;
use super::coordinate::{self, is_drawn};
use super::draft::Draft;
use super::name::Referent;
use super::reader::Reader;
use super::report::{Report, StatementPlace};
use super::value::format_number;
use super::{find, motor};
use crate::model::{JointId, JointKind, LinkId, Model, Near, StartValue};
use crate::syntax::Place;
use crate::syntax::ast::{Start, StartClause};

/// The greatest relative difference between a start and what its law gives: the two are computed differently.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

pub(super) fn lower(reader: &mut Reader, draft: &mut Draft, start: &Start) {
    for clause in &start.clauses {
        reader.report.next_item();
        if let Some(clause) = reader.report.read(clause) {
            lower_clause(reader, draft, clause);
        }
    }
}

fn lower_clause(reader: &mut Reader, draft: &mut Draft, clause: &StartClause) {
    let named = find::look_up(reader, &clause.name);
    match (named, clause.near) {
        (Some(Referent::Link(body)), true) => near(reader, draft, clause, body.id),
        (Some(Referent::Joint(Some(id))), false) => value(reader, draft, clause, id),
        (named, _) => {
            reader.value(&clause.value);
            misfit(reader, draft, clause, named);
        }
    }
}

/// Complains about a name of the wrong kind.
fn misfit(reader: &mut Reader, draft: &Draft, clause: &StartClause, named: Option<Referent>) {
    let name = &clause.name;
    if find::is_shared(reader, draft, name) {
        return;
    }
    let text = match named {
        Some(Referent::Link(_)) => {
            format!(
                "`{name}` is a link; write `{name} near {}` to choose the assembly nearest to an angle",
                clause.value
            )
        }
        Some(Referent::Joint(Some(joint))) if clause.near => {
            near_a_joint(&draft.model, clause, joint)
        }
        Some(Referent::Joint(_) | Referent::Broken) => return,
        Some(Referent::Use) => {
            find::body(reader, draft, name);
            return;
        }
        None if clause.near => {
            find::link(reader, draft, name);
            return;
        }
        None => {
            find::joint(reader, draft, name);
            return;
        }
    };
    reader.report.error(name.place(), text);
}

/// Returns the message about `near` with a joint: to write its coordinate, if that can be given, or else the angle of a link.
fn near_a_joint(model: &Model, clause: &StartClause, joint: JointId) -> String {
    let (name, value) = (&clause.name, &clause.value);
    let beginning = format!("`{name}` is a joint, and `near` takes a link");
    if let Some(text) = coordinate::missing(model, name, joint, "give") {
        return format!("{beginning}; {text}");
    }
    if model.motor_of(joint).is_some() {
        return format!("{beginning}; write `{name} = {value}`");
    }
    let (a, b) = model.ends(joint);
    let link =
        [b, a].into_iter().find(|&link| link != LinkId::GROUND && model.link(link).die.is_none());
    match (link, model.joint(joint).kind) {
        (Some(link), JointKind::Revolute(..)) => {
            let link = &model.link(link).name;
            format!(
                "{beginning}; write `{link} near {value}`, with the angle of `{link}` in the scene"
            )
        }
        (Some(link), _) => {
            let link = &model.link(link).name;
            format!(
                "{beginning}; choose the assembly by the angle of a link, such as `{link} near 0 deg`"
            )
        }
        (None, _) => beginning,
    }
}

fn near(reader: &mut Reader, draft: &mut Draft, clause: &StartClause, link: LinkId) {
    let angle = reader.value(&clause.value);
    let name = &clause.name;
    if link == LinkId::GROUND {
        reader.report.error(name.place(), "`ground` is fixed; leave this out");
    } else if draft.model.start.near.iter().any(|near| near.link == link) {
        let text = format!("there is a `near` for link `{name}` already; remove one of the two");
        reader.report.error(name.place(), text);
    } else if let Some(angle) = angle
        && !is_degrees_perhaps(reader.report, &clause.value, angle)
    {
        let origin = draft.places.note(place(clause));
        let angle = reader.frame.sense() * angle + reader.here().angle;
        draft.model.start.near.push(Near { link, angle, origin });
    }
}

fn value(reader: &mut Reader, draft: &mut Draft, clause: &StartClause, joint: JointId) {
    let Some(value) = reader.value(&clause.value) else {
        return;
    };
    if let Some((place, text)) = trouble(&draft.model, clause, joint, value) {
        reader.report.error(place, text);
        return;
    }
    let turns = draft.model.turns(joint);
    if turns && is_degrees_perhaps(reader.report, &clause.value, value) {
        return;
    }
    motor::check_start(clause, joint, value, draft, reader.report);
    let value = coordinate::own(&draft.model, &reader.frame, joint, value);
    let origin = draft.places.note(place(clause));
    draft.model.start.values.push(StartValue { joint, value, origin });
}

/// Why a joint cannot start at this value, and what to point at.
fn trouble(
    model: &Model,
    clause: &StartClause,
    joint: JointId,
    value: f64,
) -> Option<(Place, String)> {
    let name = &clause.name;
    let is_of_joint = |start: &StartValue| start.joint == joint;
    let text = if let Some(text) = coordinate::missing(model, name, joint, "give") {
        text
    } else if model.start.values.iter().any(is_of_joint) {
        format!("there is a start for joint `{name}` already; remove one of the two")
    } else if value != 0.0 && is_drawn(model, joint) {
        let text = format!(
            "joint `{name}` is placed in the drawing, where its coordinate is 0; \
             leave this out, or draw its links as they are to start"
        );
        return Some((clause.value.place, text));
    } else {
        return None;
    };
    Some((name.place(), text))
}

/// Lets every motor with a law start where that has it when the time is zero.
pub(super) fn start_by_laws(draft: &mut Draft, report: &mut Report) {
    for (motor, written) in draft.model.motors.clone().into_iter().zip(&draft.motors) {
        let Some(law) = motor.law.map(|law| draft.model.law(law)) else {
            continue;
        };
        let (value, origin) = (draft.model.at_start(law, 0.0), law.origin);
        let joint = motor.joint;
        let name = draft.model.joint(joint).name.clone();
        let place = draft.places.get(origin);
        report.enter(StatementPlace::of_mechanism(written.statement), None);
        if !value.is_finite() {
            let text = format!(
                "motor `{name}` starts where its law has it at time 0, but `{}` has no value there; \
                     change it so that it has one",
                law.written
            );
            report.error(place, text);
            continue;
        }
        let mut listed = draft.model.start.values.iter();
        if let Some(listed) = listed.find(|listed| listed.joint == joint).copied() {
            check_start_by_law(&name, value, listed, draft, report);
        } else if is_drawn(&draft.model, joint) && value.abs() > ROUNDING {
            let text = format!(
                "joint `{name}` is placed in the drawing, where its coordinate is 0, but its law starts at {}\n\n\
                     help: make the law 0 when `t` is 0, or draw its links as they are to start",
                format_number(value)
            );
            report.error(place, text);
        } else {
            motor::check_law(joint, value, draft, report);
            // Of what is drawn, rounding has been let pass.
            let value = if is_drawn(&draft.model, joint) { 0.0 } else { value };
            draft.model.start.values.push(StartValue { joint, value, origin });
        }
    }
}

/// A start that was given must be that of the law.
fn check_start_by_law(
    name: &str,
    value: f64,
    listed: StartValue,
    draft: &Draft,
    report: &mut Report,
) {
    let scale = value.abs().max(listed.value.abs()).max(1.0);
    if (value - listed.value).abs() <= ROUNDING * scale {
        return;
    }
    let text = format!(
        "motor `{name}` starts at {} by its law, not at {}; leave this out, or change one of the two",
        format_number(value),
        format_number(listed.value)
    );
    report.error(draft.places.get(listed.origin), text);
}

fn place(clause: &StartClause) -> Place {
    clause.name.place().to(clause.value.place)
}
