//! The actions on the links.

use super::draft::Draft;
use super::find;
use super::reader::{Located, Reader};
use super::report::Report;
use crate::api::Owner;
use crate::bug::bug;
use crate::model::{
    AxisId, AxisKind, Between, Damper, JointId, JointKind, LinkId, Load, LoadKind, Model, Spring,
};
use crate::syntax::Place;
use crate::syntax::ast::{
    self, BetweenEnds, Effect, Elastic, ElasticBody, End, LoadOn, Name, Pair, Statement,
};
use crate::syntax::limits::Limit;

pub(super) fn gravity(reader: &mut Reader, draft: &mut Draft, value: &Pair) {
    let gravity = &mut draft.model.actions.gravity;
    *gravity = gravity.or(reader.pair(value));
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
    let is_own = draft.claims.has(&name, &format!("spring `{}`", spring.name));
    if !is_own || known.any(|known| known.name == name) {
        return;
    }
    if let Ok(ElasticBody { between: BetweenEnds::Points(_), .. }) = spring.body {
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

/// Reads the ends of a spring or damper and its strength; returns them with the rest of its body.
fn elastic<'e>(
    reader: &mut Reader,
    draft: &mut Draft,
    elastic: &'e Elastic,
    what: &str,
    strength: &str,
) -> Option<(Between, f64, &'e ElasticBody)> {
    let kept = draft.claims.take_name(reader, &elastic.name, what);
    let body = reader.report.read(&elastic.body)?;
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
            let (a, b) =
                (end_point(reader, draft, first, what), end_point(reader, draft, second, what));
            let (a, b) = (a?, b?);
            if draft.model.axis(a).link == draft.model.axis(b).link {
                let link = &second.link;
                let text = format!(
                    "both ends of this {what} are on `{link}`, where it does nothing; fix one of them to another link"
                );
                return reader.report.refuse(first.place().to(second.place()), text);
            }
            if let Some(joint) = pinned_together(&draft.model, a, b) {
                let text = format!(
                    "joint `{joint}` holds both ends of this {what} together; fix one of them elsewhere"
                );
                return reader.report.refuse(first.place().to(second.place()), text);
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
    joints.find(|joint| holds(joint.kind)).map(|joint| joint.name.as_str())
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
    reader.report.refuse(name.place(), text)
}

/// The point at which something is fixed.
fn end_point(reader: &mut Reader, draft: &Draft, end: &End, what: &str) -> Option<AxisId> {
    let link = find::body(reader, draft, &end.link)?;
    let Some(name) = &end.axis else {
        let points = reader.names.axes_of(&draft.model, link, Some(AxisKind::Point));
        let text = match points.first() {
            Some(point) => format!("a {what} is fixed to a point: `{}.{point}`", end.link),
            None => format!("a {what} is fixed to a point; declare one in `{}`", end.link),
        };
        return reader.report.refuse(end.place(), text);
    };
    let axis = find::axis(reader, draft, link, name, Some(AxisKind::Point))?;
    if draft.model.axis(axis).kind == AxisKind::Line {
        let text = format!("`{end}` is a line; a {what} is fixed to a point");
        return reader.report.refuse(Place::at(name.span()), text);
    }
    Some(axis)
}

pub(super) fn load(reader: &mut Reader, draft: &mut Draft, load: &ast::Load) {
    let kept = draft.claims.take_name(reader, &load.name, "load");
    let Some(on) = reader.report.read(&load.on) else {
        return;
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
            (format!("{name}_advantage"), format!("the advantage over load `{name}`")),
        ];
        for (method, owner) in methods {
            let place = Place::at(load.name.span());
            draft.claims.take(method, owner, place, reader.report);
        }
        let origin = draft.note(&load.name);
        draft.model.actions.loads.push(Load { name, origin, kind });
    }
}

/// Reports actions that have nothing to act on, and actions whose effects nothing asks for.
pub(super) fn check(draft: &Draft, statements: &[Located], report: &mut Report) {
    // A statement that seems to be missing may only be wrong.
    if !report.is_empty() {
        return;
    }
    let model = &draft.model;
    let (actions, effects) = (&model.actions, model.effects);
    if let Some((limit, effect)) = beyond(model) {
        let place = asked(statements, effect);
        let place = place.unwrap_or_else(|| bug!("effect `{effect}` is asked for nowhere"));
        report.error(place, limit.to_string());
        return;
    }
    let masses = || model.links.iter().filter_map(|link| link.mass.as_ref());
    let has_mass = masses().any(|mass| mass.mass + mass.inertia > 0.0);
    let acts = has_mass
        || !(actions.springs.is_empty() && actions.dampers.is_empty() && actions.loads.is_empty());
    let (place, text) = if actions.gravity.is_some() && !masses().any(|mass| mass.mass > 0.0) {
        let text = "no link has a mass on which gravity could act; give a link `mass` or `density`";
        (gravity_of(statements), text.to_owned())
    } else if effects.dynamics && !has_mass {
        let text = "nothing has a mass that would keep it moving; give links `mass` or `density`";
        (asked(statements, "dynamics"), text.to_owned())
    } else if effects.force && !acts {
        let text = "there are no forces: declare a `load`, a `spring`, or the `mass` of a link";
        (asked(statements, "force"), text.to_owned())
    } else if let (Some(load), false) = (actions.loads.first(), effects.needs_actions()) {
        let text = format!(
            "nothing asks what load `{}` does; add `effects {{ force; }}` or `dynamics`, or leave it out",
            load.name
        );
        (Some(draft.places.get(load.origin)), text)
    } else {
        return;
    };
    if let Some(place) = place {
        report.error(place, text);
    }
}

/// The limit that the links of a mechanism exceed for what is computed of them, and the effect that computes it.
fn beyond(model: &Model) -> Option<(Limit, &'static str)> {
    let effects = model.effects;
    let asked = [
        (effects.force, Limit::Forces, "force"),
        (effects.dynamics, Limit::Forces, "dynamics"),
        (effects.velocity, Limit::Rates, "velocity"),
        (effects.sensitivity, Limit::Rates, "sensitivity"),
    ];
    let links = model.declared_links().count();
    let mut beyond = asked.into_iter();
    let (_, limit, effect) =
        beyond.find(|(is_asked, limit, _)| *is_asked && links > limit.most())?;
    Some((limit, effect))
}

/// Where gravity is given, if it is.
fn gravity_of(statements: &[Located]) -> Option<Place> {
    let mut all = statements.iter();
    all.find_map(|located| match located.statement {
        Statement::Gravity { keyword, .. } => Some(Place::at(*keyword)),
        _ => None,
    })
}

/// Where an effect is asked for, if it is.
fn asked(statements: &[Located], effect: &str) -> Option<Place> {
    let mut last_first = statements.iter().rev();
    last_first.find_map(|located| match located.statement {
        Statement::Effects { effects, .. } => effects.iter().find_map(|one| match one {
            Ok(Effect::Plain(word)) if word == effect => Some(Place::at(word.span())),
            _ => None,
        }),
        _ => None,
    })
}

/// The methods that forces add must not be called as others are.
pub(super) fn take_methods(draft: &mut Draft, statements: &[Located], report: &mut Report) {
    let (force, dynamics) = (asked(statements, "force"), asked(statements, "dynamics"));
    let picture = force.filter(|_| draft.model.effects.overlay);
    let owners = [Owner::Force, Owner::Dynamics, Owner::Overlay];
    for (owner, place) in owners.into_iter().zip([force, dynamics, picture]) {
        if let Some(place) = place {
            draft.claims.take_all(owner, place, report);
        }
    }
}
