//! The effects, and the methods that return their results.

use super::draft::Draft;
use super::path::choices;
use super::reader::Reader;
use super::report::Report;
use super::trace;
use crate::api::Owner;
use crate::model::{AxisKind, Effects, JointKind, LinkId, Model, Origin};
use crate::syntax::Place;
use crate::syntax::ast::{EFFECTS, Effect, Read};
use proc_macro2::Ident;

pub(super) fn lower(reader: &mut Reader, draft: &mut Draft, effects: &[Read<Effect>]) {
    let mut listed: Vec<&Ident> = Vec::new();
    for effect in effects {
        reader.report.next_item();
        match effect {
            Ok(Effect::Trace(trace)) => {
                for every in choices(reader, &trace.point.link) {
                    let mut reader = Reader { every: &every, ..reader.again() };
                    trace::lower(&mut reader, draft, trace);
                }
            }
            Ok(Effect::Plain(effect)) if listed.contains(&effect) => {
                let text = format!("`{effect}` is listed already; remove one of the two");
                reader.report.error(Place::at(effect.span()), text);
            }
            Ok(Effect::Plain(effect)) => {
                listed.push(effect);
                lower_plain(reader, draft, effect);
            }
            Err(error) => reader.report.pass_on(error.clone()),
        }
    }
}

fn lower_plain(reader: &mut Reader, draft: &mut Draft, effect: &Ident) {
    let text = effect.to_string();
    let effects = &mut draft.model.effects;
    match text.as_str() {
        "velocity" => effects.velocity = true,
        // Accelerations are made from velocities.
        "acceleration" => (effects.velocity, effects.acceleration) = (true, true),
        "force" => effects.force = true,
        "dynamics" => effects.dynamics = true,
        "overlay" => effects.overlay = true,
        "sensitivity" if draft.has_params => effects.sensitivity = true,
        "sensitivity" => {
            let text = "`sensitivity` tells how everything follows the params, and there is none; write \
                 `param name = ...;` for a number that points depend on, or leave this out";
            reader.report.error(Place::at(effect.span()), text);
        }
        _ => reader.report.unknown(effect, "effect", &EFFECTS),
    }
}

/// Effects that contradict what motors do.
pub(super) fn check(draft: &Draft, report: &mut Report) {
    let model = &draft.model;
    // With an error elsewhere, there may be no contradiction.
    if let Some((motor, _)) = model.lawful_motors().next()
        && model.effects.dynamics
        && report.is_empty()
    {
        let motor = model.motor(motor);
        let text = format!(
            "motor `{}` follows a law, so forces cannot move it; leave out its law, or the effect `dynamics`",
            model.joint(motor.joint).name
        );
        report.error(draft.places.get(motor.origin), text);
    }
}

/// Claims the names of the methods that return rates.
pub(super) fn take_rate_methods(draft: &mut Draft, report: &mut Report) {
    let Effects { velocity, acceleration, sensitivity, .. } = draft.model.effects;
    for (name, owner, origin, rate) in accessors(&draft.model) {
        let place = draft.places.get(origin);
        let rates =
            [(velocity, rate), (acceleration, "acceleration"), (sensitivity, "sensitivity")];
        for (_, what) in rates.into_iter().filter(|(wanted, _)| *wanted) {
            let (method, owner) = (format!("{name}_{what}"), format!("the {what} of {owner}"));
            draft.claims.take(method, owner, place, report);
        }
    }
}

/// The method that follows laws must not be called as others are.
pub(super) fn take_time_method(draft: &mut Draft, report: &mut Report) {
    let first = draft.model.lawful_motors().next().map(|(motor, _)| motor);
    if let Some(motor) = first {
        let place = draft.places.get(draft.model.motor(motor).origin);
        draft.claims.take_all(Owner::Laws, place, report);
    }
}

/// Everything that has a method of its own: its name, what it is, where it was declared, and what its rate is called.
fn accessors(model: &Model) -> Vec<(String, String, Origin, &'static str)> {
    let links = model.declared_links().map(|id| {
        let link = model.link(id);
        (link.name.clone(), format!("link `{}`", link.name), link.origin, "velocity")
    });
    let points = model.axes.iter().filter_map(|axis| {
        let name = axis.name.as_deref()?;
        let is_exposed = axis.kind == AxisKind::Point && axis.link != LinkId::GROUND;
        let link = model.owner_of(axis);
        let owner = format!("point `{link}.{name}`");
        is_exposed.then(|| (format!("{link}_{name}"), owner, axis.origin, "velocity"))
    });
    let joints = model.joints.iter().filter(|joint| {
        let moves = matches!(joint.kind, JointKind::Revolute(..) | JointKind::Prismatic(..));
        moves && !joint.hidden
    });
    let joints = joints
        .map(|joint| (joint.name.clone(), format!("joint `{}`", joint.name), joint.origin, "rate"));
    links.chain(points).chain(joints).collect()
}
