//! Cams: a law between two joints.

use super::constant::COORDINATE;
use super::draft::Draft;
use super::ends::Joining;
use super::path::key;
use super::quantity::Quantity;
use super::reader::{Argument, Nature, Reader};
use super::{find, law, rolling};
use crate::model::{AxisKind, JointId, JointKind, LinkId, Model, Roller};
use crate::syntax::Place;
use crate::syntax::ast::{End, RollerExpr};

/// A cam, if it can be understood.
pub(super) fn cam(reader: &mut Reader, draft: &mut Draft, joining: &Joining) -> Option<JointKind> {
    let body = joining.body;
    let ends = body.ends.each_ref().map(|end| cam_end(reader, draft, end));
    let factors = ends.map(|joint| factor_of(reader, draft, joint));
    let law = body.law.as_ref();
    let nature = nature(draft, ends);
    let law = law.and_then(|expr| law::read(reader, draft, expr, COORDINATE, factors, nature));
    let why = "shaft and its follower are where their joints are";
    joining.refuse_place(reader, why);
    let [shaft, follower] = [ends[0]?, ends[1]?];
    let place = body.ends[0].place().to(body.ends[1].place());
    if shaft == follower {
        let text = format!(
            "cam `{}` is between `{}` and itself; name the joints of its shaft and of its follower",
            joining.name, body.ends[1]
        );
        return reader.report.refuse(place, text);
    }
    if draft.model.carrier_of_cam(shaft, follower).is_none() {
        apart(reader, draft, place, shaft, follower);
        return None;
    }
    let roller = match &body.roller {
        Some(expr) => Some(roller(reader, draft, expr, [shaft, follower])?),
        None => None,
    };
    draft.model.rollers.extend(roller);
    let law = law?;
    Some(JointKind::Cam { shaft, follower, law })
}

/// The joint of a shaft or a follower: one that has a coordinate.
fn cam_end(reader: &mut Reader, draft: &Draft, end: &End) -> Option<JointId> {
    if end.axis.is_some() {
        let text = format!(
            "a `cam` takes joints, that of its shaft and that of its follower; `{end}` is none"
        );
        return reader.report.refuse(end.place(), text);
    }
    let name = key(reader, &end.link)?;
    let (joint, word) = if reader.names.cams.contains(&name) {
        (None, Some("cam"))
    } else {
        let joint = find::joint(reader, draft, &end.link)?;
        (Some(joint), unfit_for_cam(&draft.model, joint))
    };
    if let Some(word) = word {
        let text =
            format!("`{end}` is a {word}; a `cam` takes joints that are `revolute` or `prismatic`");
        return reader.report.refuse(end.place(), text);
    }
    joint
}

/// Returns the factor from the coordinate of a joint as a part gives it to that of the joint itself.
fn factor_of(reader: &mut Reader, draft: &Draft, joint: Option<JointId>) -> Quantity {
    match joint.map(|joint| draft.model.joint(joint).kind) {
        Some(JointKind::Prismatic(..)) => reader.frame.scale,
        Some(_) => Quantity::fixed(reader.frame.sense()),
        None => Quantity::fixed(1.0),
    }
}

/// The roller of a cam that is about to be entered, if it can be understood.
fn roller(
    reader: &mut Reader,
    draft: &mut Draft,
    expr: &RollerExpr,
    [shaft, follower]: [JointId; 2],
) -> Option<Roller> {
    let end = &expr.point;
    let body = find::body(reader, draft, &end.link)?;
    let carrier = draft.model.carrier_of_cam(shaft, follower)?;
    let (own, _) = draft.model.beside(follower, carrier)?;
    let (own, pivot) = (draft.model.axis(own).link, draft.model.axis(own).at);
    let name = &draft.model.link(own).name;
    let Some(point) = &end.axis else {
        let text = format!("`{end}` is a link; a roller is at a point of `{name}`, the follower");
        return reader.report.refuse(end.place(), text);
    };
    let axis = find::axis(reader, draft, body, point, Some(AxisKind::Point))?;
    let radius = reader
        .fixed("the disc of a cam is made for one roller")
        .length(&expr.radius, "the radius of a roller");
    let turns = draft.model.turns(follower);
    let found = draft.model.axis(axis);
    let text = if found.kind == AxisKind::Line {
        format!("`{end}` is a line; a roller is at a point of `{name}`, the follower")
    } else if found.link != own {
        format!("`{end}` does not follow this cam; name a point of `{name}`")
    } else if turns && found.at == pivot {
        format!(
            "`{name}` turns about `{end}`, so a roller there stays in its place; name another point of it"
        )
    } else {
        let scale = reader.frame.scale.value?;
        return Some(Roller {
            cam: JointId::new(draft.model.joints.len()),
            point: axis,
            radius: scale * radius?.0,
            origin: draft.places.note(end.place()),
        });
    };
    reader.report.refuse(end.place(), text)
}

/// What the law of a cam between these joints is a function of, and what it gives.
fn nature(draft: &Draft, [shaft, follower]: [Option<JointId>; 2]) -> Option<Nature> {
    let slides = |joint| matches!(draft.model.joint(joint).kind, JointKind::Prismatic(..));
    let of = if slides(shaft?) { Argument::Length } else { Argument::Angle };
    let is_angle = !slides(follower?);
    Some(Nature { of, is_angle })
}

/// Returns the word for a joint that cannot be the shaft or the follower of a cam; none for others.
fn unfit_for_cam(model: &Model, joint: JointId) -> Option<&'static str> {
    let kind = model.joint(joint).kind;
    let (a, b) = model.ends(joint);
    let on_die = [a, b].iter().any(|&link| model.link(link).die.is_some());
    match kind {
        JointKind::Weld(..) => Some("weld"),
        _ if on_die => Some("slot"),
        _ => rolling::word_for(kind),
    }
}

/// Complains about joints that have no link in common.
fn apart(reader: &mut Reader, draft: &Draft, place: Place, shaft: JointId, follower: JointId) {
    let name = |link: LinkId| format!("`{}`", draft.model.link(link).name);
    let joins = |joint: JointId| {
        let (a, b) = draft.model.ends(joint);
        format!("`{}` joins {}", draft.model.joint(joint).name, [name(a), name(b)].join(" to "))
    };
    let text = format!(
        "the shaft and the follower of a cam are carried by one link, but {} and {}; name two joints with a link in common",
        joins(shaft),
        joins(follower)
    );
    reader.report.error(place, text);
}
