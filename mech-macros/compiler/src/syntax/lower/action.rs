//! What acts on the links.

use super::draft::Draft;
use super::find;
use super::reader::Reader;
use super::report::Report;
use crate::api::Owner;
use crate::model::{
    AxisId, AxisKind, Between, Damper, JointId, JointKind, LinkId, Load, LoadKind, Mass, Model,
    Spring,
};
use crate::syntax::Place;
use crate::syntax::ast::{self, BetweenEnds, Elastic, ElasticBody, End, LoadOn, Name, Pair};
use proc_macro2::Span;

pub(super) fn gravity(
    reader: &mut Reader,
    draft: &mut Draft,
    acting: &mut ActionPlaces,
    keyword: Span,
    value: &Pair,
) {
    let value = reader.pair(value);
    if let Some(value) = value.filter(|_| draft.model.actions.gravity.is_none()) {
        draft.model.actions.gravity = Some(value);
        acting.gravity = Some(Place::at(keyword));
    }
}

pub(super) fn spring(reader: &mut Reader, draft: &mut Draft, spring: &Elastic) {
    let Some((between, strength, body)) = elastic(reader, draft, spring, "spring", "a stiffness")
    else {
        return keep_spring(reader, draft, spring);
    };
    let rest = match &body.rest {
        None => Some(0.0),
        Some(rest) if matches!(between, Between::Points(..)) => {
            reader.not_negative(rest, "a length at rest")
        }
        Some(rest) => reader.value(rest),
    };
    let (scale, sense) = (reader.frame.start_scale(), reader.frame.sense());
    let rest = rest.map(|rest| match between {
        Between::Points(..) => scale * rest,
        Between::Joint(_) => sense * rest,
    });
    let origin = draft.note(&spring.name);
    if let Some(rest) = rest {
        draft.model.actions.springs.push(Spring {
            name: reader.key_of(&spring.name),
            origin,
            between,
            stiffness: strength,
            rest,
        });
    }
}

/// Keeps the name of a spring that is wrong: its method is not to be missed elsewhere. Nothing is made of a mechanism with errors.
fn keep_spring(reader: &mut Reader, draft: &mut Draft, spring: &Elastic) {
    let name = reader.key_of(&spring.name);
    let mut known = draft.model.actions.springs.iter();
    let is_own = draft
        .claims
        .has(&name, &format!("spring `{}`", spring.name));
    if !is_own || known.any(|known| known.name == name) {
        return;
    }
    if let Ok(ElasticBody {
        between: BetweenEnds::Points(_),
        ..
    }) = spring.body
    {
        let (origin, nowhere) = (draft.note(&spring.name), AxisId::new(0));
        draft.model.actions.springs.push(Spring {
            name,
            origin,
            between: Between::Points(nowhere, nowhere),
            stiffness: 0.0,
            rest: 0.0,
        });
    }
}

pub(super) fn damper(reader: &mut Reader, draft: &mut Draft, damper: &Elastic) {
    let Some((between, damping, _)) = elastic(reader, draft, damper, "damper", "a damping") else {
        return;
    };
    let origin = draft.note(&damper.name);
    draft.model.actions.dampers.push(Damper {
        name: reader.key_of(&damper.name),
        origin,
        between,
        damping,
    });
}

/// What a spring or damper lies between, its strength, and what else was said of it.
fn elastic<'e>(
    reader: &mut Reader,
    draft: &mut Draft,
    elastic: &'e Elastic,
    what: &str,
    strength: &str,
) -> Option<(Between, f64, &'e ElasticBody)> {
    let kept = draft.claims.take_name(reader, &elastic.name, what);
    let body = match &elastic.body {
        Ok(body) => body,
        Err(error) => {
            reader.report.pass_on(error.clone());
            return None;
        }
    };
    let between = resolve_between(reader, draft, &body.between, what);
    let strength = reader.not_negative(&body.strength, strength);
    let both = between.zip(strength).filter(|_| kept);
    both.map(|(between, strength)| (between, strength, body))
}

fn resolve_between(
    reader: &mut Reader,
    draft: &Draft,
    ends: &BetweenEnds,
    what: &str,
) -> Option<Between> {
    match ends {
        BetweenEnds::Points([first, second]) => {
            let (a, b) = (
                end_point(reader, draft, first, what),
                end_point(reader, draft, second, what),
            );
            let (a, b) = (a?, b?);
            if draft.model.axis(a).link == draft.model.axis(b).link {
                let link = &second.link;
                let text = format!(
                    "both ends of this {what} are on `{link}`, where it does nothing; fix one of them to another link"
                );
                reader.report.error(first.place().to(second.place()), text);
                return None;
            }
            if let Some(joint) = pinned_together(&draft.model, a, b) {
                let text = format!(
                    "joint `{joint}` holds both ends of this {what} together; fix one of them elsewhere"
                );
                reader.report.error(first.place().to(second.place()), text);
                return None;
            }
            Some(Between::Points(a, b))
        }
        BetweenEnds::Joint(name) => find_turning(reader, draft, name, what).map(Between::Joint),
    }
}

/// The joint that holds two points together, if one does.
fn pinned_together(model: &Model, a: AxisId, b: AxisId) -> Option<&str> {
    let mut joints = model.joints.iter();
    let holds = |kind: JointKind| match kind {
        JointKind::Revolute(p, q) | JointKind::Weld(p, q) => [p, q] == [a, b] || [q, p] == [a, b],
        _ => false,
    };
    joints
        .find(|joint| holds(joint.kind))
        .map(|joint| joint.name.as_str())
}

/// The joint of this name, if it turns.
fn find_turning(reader: &mut Reader, draft: &Draft, name: &Name, what: &str) -> Option<JointId> {
    let joint = find::joint(reader, draft, name)?;
    if let JointKind::Revolute(..) = draft.model.joint(joint).kind {
        return Some(joint);
    }
    let text = format!(
        "joint `{name}` is not a revolute; a {what} at a joint turns its links, one between points is `linear(a.p, b.q)`"
    );
    reader.report.error(name.place(), text);
    None
}

/// The point at which something is fixed.
fn end_point(reader: &mut Reader, draft: &Draft, end: &End, what: &str) -> Option<AxisId> {
    let link = find::body(reader, draft, &end.link)?;
    let Some(name) = &end.axis else {
        let points = reader
            .names
            .axes_of(&draft.model, link, Some(AxisKind::Point));
        let text = match points.first() {
            Some(point) => format!("a {what} is fixed to a point: `{}.{point}`", end.link),
            None => format!(
                "a {what} is fixed to a point; declare one in `{}`",
                end.link
            ),
        };
        reader.report.error(end.place(), text);
        return None;
    };
    let axis = find::axis(reader, draft, link, name, Some(AxisKind::Point))?;
    if draft.model.axis(axis).kind == AxisKind::Line {
        let text = format!("`{end}` is a line; a {what} is fixed to a point");
        reader.report.error(Place::at(name.span()), text);
        return None;
    }
    Some(axis)
}

pub(super) fn load(reader: &mut Reader, draft: &mut Draft, load: &ast::Load) {
    let kept = draft.claims.take_name(reader, &load.name, "load");
    let on = match &load.on {
        Ok(on) => on,
        Err(error) => return reader.report.pass_on(error.clone()),
    };
    let kind = match on {
        LoadOn::Force(end) => end_point(reader, draft, end, "load").map(LoadKind::Force),
        LoadOn::Torque(name) => find::link(reader, draft, name).map(LoadKind::Torque),
    };
    let Some(kind) = kind else {
        // Its methods are not to be missed elsewhere; nothing is made of a mechanism with errors.
        let kind = match on {
            LoadOn::Force(_) => LoadKind::Force(AxisId::new(0)),
            LoadOn::Torque(_) => LoadKind::Torque(LinkId::GROUND),
        };
        let (name, origin) = (reader.key_of(&load.name), draft.note(&load.name));
        if kept {
            draft.model.actions.loads.push(Load { name, origin, kind });
        }
        return;
    };
    let link = match kind {
        LoadKind::Force(point) => draft.model.axis(point).link,
        LoadKind::Torque(link) => link,
    };
    if link == LinkId::GROUND {
        let text = "a load on the ground does nothing; put it on a link that moves";
        return reader.report.error(Place::at(load.name.span()), text);
    }
    if kept {
        let name = reader.key_of(&load.name);
        let setter = format!("{}set_{}", reader.here().prefix, load.name);
        let methods = [
            (setter, format!("load `{name}`")),
            (
                format!("{name}_advantage"),
                format!("the advantage over load `{name}`"),
            ),
        ];
        for (method, owner) in methods {
            let place = Place::at(load.name.span());
            draft.claims.take(method, owner, place, reader.report);
        }
        let origin = draft.note(&load.name);
        draft.model.actions.loads.push(Load { name, origin, kind });
    }
}

/// Effects that contradict what motors do.
pub(super) fn check_effects(draft: &Draft, acting: &ActionPlaces, report: &mut Report) {
    // What stands beside them may only be wrong.
    if !report.is_empty() {
        return;
    }
    if acting.dynamics.is_some()
        && let Some((motor, _)) = draft.model.lawful_motors().next()
    {
        let motor = draft.model.motor(motor);
        let text = format!(
            "motor `{}` follows a law, so forces cannot move it; leave out its law, or the effect `dynamics`",
            draft.model.joint(motor.joint).name
        );
        let place = draft.places.get(motor.origin);
        report.error(place, text);
    }
}

/// What acts must have something to act on, and something must ask for it.
pub(super) fn check_actions(draft: &Draft, acting: &ActionPlaces, report: &mut Report) {
    // What is missing may only be wrong.
    if !report.is_empty() {
        return;
    }
    let actions = &draft.model.actions;
    let has_mass = |axis: fn(&Mass) -> f64| {
        draft
            .model
            .links
            .iter()
            .filter_map(|link| link.mass.as_ref())
            .any(|mass| axis(mass) > 0.0)
    };
    if let (Some(place), false) = (acting.gravity, has_mass(|mass| mass.mass)) {
        let text = "no link has a mass on which gravity could act; give a link `mass` or `density`";
        return report.error(place, text);
    }
    if let Some(place) = acting.dynamics
        && !has_mass(|mass| mass.mass + mass.inertia)
    {
        let text = "nothing has a mass that would keep it moving; give links `mass` or `density`";
        return report.error(place, text);
    }
    let nothing =
        actions.springs.is_empty() && actions.dampers.is_empty() && actions.loads.is_empty();
    if let Some(place) = acting.force
        && nothing
        && !has_mass(|mass| mass.mass + mass.inertia)
    {
        let text = "there are no forces: declare a `load`, a `spring`, or the `mass` of a link";
        return report.error(place, text);
    }
    if let (Some(load), false) = (actions.loads.first(), draft.model.effects.needs_actions()) {
        let text = format!(
            "nothing asks what load `{}` does; add `effects {{ force; }}` or `dynamics`, or leave it out",
            load.name
        );
        let place = draft.places.get(load.origin);
        report.error(place, text);
    }
}

/// The methods that forces add must not be called as others are.
pub(super) fn take_methods(draft: &mut Draft, acting: &ActionPlaces, report: &mut Report) {
    let ActionPlaces {
        force, dynamics, ..
    } = *acting;
    let picture = force.filter(|_| draft.model.effects.overlay);
    for (place, owner) in [
        (force, Owner::Force),
        (dynamics, Owner::Dynamics),
        (picture, Owner::Overlay),
    ] {
        if let Some(place) = place {
            draft.claims.take_all(owner, place, report);
        }
    }
}

/// Where gravity and effects stand, for messages.
#[derive(Clone, Copy, Default)]
pub(super) struct ActionPlaces {
    pub(super) gravity: Option<Place>,
    pub(super) force: Option<Place>,
    pub(super) dynamics: Option<Place>,
}
