//! The search for the referents of names; unknown names are reported.

use super::draft::Draft;
use super::name::{Body, Referent, divide, word_for};
use super::path::key;
use super::reader::Reader;
use crate::model::{Axis, AxisId, AxisKind, JointId, JointKind, LinkId, Model, MotorId, Origin};
use crate::syntax::ast::Name;
use crate::syntax::{Noun, Place, spelling};
use proc_macro2::Ident;

/// Returns the referent of this name, if there is one.
pub(super) fn look_up(reader: &mut Reader, name: &Name) -> Option<Referent> {
    match key(reader, name) {
        Some(key) => reader.names.get(&key),
        // Reported.
        None => Some(Referent::Broken),
    }
}

/// Whether both a link and a joint claim this name.
pub(super) fn is_shared(reader: &mut Reader, draft: &Draft, name: &Name) -> bool {
    key(reader, name).is_some_and(|key| draft.claims.is_shared(&key))
}

/// The link of this name.
pub(super) fn link(reader: &mut Reader, draft: &Draft, name: &Name) -> Option<LinkId> {
    body(reader, draft, name).map(|body| body.id)
}

/// The link of this name, and how it is known there.
pub(super) fn body(reader: &mut Reader, draft: &Draft, name: &Name) -> Option<Body> {
    let (text, key) = (name.to_string(), key(reader, name)?);
    let trouble = match reader.names.get(&key) {
        Some(Referent::Link(body)) => return Some(body),
        Some(Referent::Broken) => return None,
        Some(Referent::Joint(_)) if draft.claims.is_shared(&key) => return None,
        Some(Referent::Use) => used_as(&text, "link"),
        Some(Referent::Joint(_)) => {
            let links = reader.names.links(&key);
            format!("`{text}` is a joint; this must be a link, one of {}", spelling::list(&links))
        }
        None if name.name == "ground" => format!(
            "a part has no ground of its own; declare `port {};`, and lend it `ground` where the part is used",
            "frame"
        ),
        None => format!(
            "unknown link `{text}`{}",
            spelling::remedy(divide(&key).1, &reader.names.links(&key))
        ),
    };
    let unknown = reader.names.unknown(Noun::Body, &key);
    reader.report.refuse_unknown(unknown, name.place(), trouble)
}

/// The motor of this name.
pub(super) fn motor(reader: &mut Reader, draft: &Draft, name: &Name) -> Option<MotorId> {
    let id = joint(reader, draft, name)?;
    let found = draft.model.motor_of(id);
    if found.is_none() {
        let motors = draft.model.motors.iter();
        let names = motors.map(|motor| format!("`{}`", draft.model.joint(motor.joint).name));
        let names: Vec<String> = names.collect();
        let text = format!(
            "joint `{name}` has no motor, so its values cannot be chosen; there {} {}",
            if names.len() == 1 { "is" } else { "are" },
            names.join(", ")
        );
        return reader.report.refuse(name.place(), text);
    }
    found
}

/// The joint of this name.
pub(super) fn joint(reader: &mut Reader, draft: &Draft, name: &Name) -> Option<JointId> {
    let (text, key) = (name.to_string(), key(reader, name)?);
    let trouble = match reader.names.get(&key) {
        Some(Referent::Joint(id)) => return id,
        Some(Referent::Broken) => return None,
        Some(Referent::Link(_)) if draft.claims.is_shared(&key) => return None,
        Some(Referent::Link(body)) => not_a_joint(&draft.model, body.id),
        Some(Referent::Use) => used_as(&text, "joint"),
        None => match point_called(&draft.model, &text) {
            Some(link) => format!(
                "`{text}` is a point of link `{}`, not a joint: a joint joins two links{}",
                draft.model.link(link).name,
                spelling::remedy(&text, &reader.names.joints(&key))
            ),
            None => format!(
                "unknown joint `{text}`{}",
                spelling::remedy(divide(&key).1, &reader.names.joints(&key))
            ),
        },
    };
    let unknown = reader.names.unknown(Noun::Joint, &key);
    reader.report.refuse_unknown(unknown, name.place(), trouble)
}

/// The first link that has a point of this name.
pub(super) fn point_called(model: &Model, name: &str) -> Option<LinkId> {
    let mut axes = model.axes.iter();
    let called = |axis: &&Axis| axis.name.as_deref() == Some(name);
    axes.find(called).map(|axis| axis.link)
}

fn not_a_joint(model: &Model, link: LinkId) -> String {
    let name = &model.link(link).name;
    let joints = model.joint_ids().filter(|&joint| {
        let (a, b) = model.ends(joint);
        let kind = model.joint(joint).kind;
        let moves = matches!(kind, JointKind::Revolute(..) | JointKind::Prismatic(..));
        moves && (a == link || b == link)
    });
    let joints: Vec<_> = joints.map(|joint| model.joint(joint).name.as_str()).collect();
    match joints.as_slice() {
        [] => format!("`{name}` is a link; this must be a joint"),
        joints => format!("`{name}` is a link; name one of its joints: {}", spelling::list(joints)),
    }
}

/// Complains about a name that is neither a link's nor a joint's.
pub(super) fn refuse_unknown(reader: &mut Reader, name: &Name) {
    let Some(key) = key(reader, name) else {
        return;
    };
    let text = name.to_string();
    let joints = reader.names.joints(&key);
    let noun = match spelling::nearest(divide(&key).1, &joints) {
        Some(_) => Noun::Joint,
        None => Noun::Body,
    };
    let candidates: Vec<_> = [reader.names.links(&key), joints].concat();
    let remedy = spelling::remedy(divide(&key).1, &candidates);
    let trouble = format!("unknown link or joint `{text}`{remedy}");
    let unknown = reader.names.unknown(noun, &key);
    reader.report.refuse_unknown::<()>(unknown, name.place(), trouble);
}

/// The axis of this name on a link; of this kind, if one is given.
pub(super) fn axis(
    reader: &mut Reader,
    draft: &Draft,
    link: Body,
    name: &Ident,
    kind: Option<AxisKind>,
) -> Option<AxisId> {
    let text = name.to_string();
    if let Some(id) = reader.names.axis_of(&draft.model, link, &text) {
        return Some(id);
    }
    if draft.is_lost(link, &text) {
        return None;
    }
    let link_name = reader.names.name_of(&draft.model, link);
    let what = kind.map_or("point or line", word_for);
    let candidates = reader.names.axes_of(&draft.model, link, kind);
    let remedy = if candidates.is_empty() {
        format!("; declare it in `{link_name}`")
    } else {
        spelling::remedy(&text, &candidates)
    };
    let message = format!("`{link_name}` has no {what} `{text}`{remedy}");
    let is_declared = draft.model.link(link.id).origin != Origin::default();
    let name_of_all = if is_declared { text.as_str() } else { "" };
    let unknown = reader.names.unknown_axis(link_name, name_of_all);
    reader.report.refuse_unknown(unknown, Place::at(name.span()), message)
}

/// Returns the message about a use of a part where one of its links or joints should be.
fn used_as(name: &str, what: &str) -> String {
    format!("`{name}` is a use of a part; name one of its {what}s, as `{name}.{what}`")
}
