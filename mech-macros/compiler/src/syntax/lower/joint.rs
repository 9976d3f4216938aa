//! Joints.

use super::draft::Draft;
use super::ends::Joining;
use super::name::Referent;
use super::reader::Reader;
use super::{cam, find, given, rolling};
use crate::model::{self, AxisId, AxisKind, DrawnAxis, JointId, JointKind};
use crate::syntax::Place;
use crate::syntax::ast::{Joint, JointWord};

/// Declares a joint and returns its referent; its axes follow when all links are known.
pub(super) fn declare(reader: &mut Reader, draft: &mut Draft, joint: &Joint) -> Referent {
    let is_taken = draft.claims.take_name(reader, &joint.name, "joint");
    reader.report.read(&joint.body);
    if is_taken { Referent::Joint(None) } else { Referent::Broken }
}

/// Whether a joint is a cam, as far as it could be read.
pub(super) fn is_cam(joint: &Joint) -> bool {
    joint.body.as_ref().is_ok_and(|body| body.kind == JointWord::Cam)
}

/// Enters a joint, if it can be understood. One that cannot have its name is left out.
pub(super) fn lower(
    reader: &mut Reader,
    draft: &mut Draft,
    joint: &Joint,
    is_named: bool,
) -> Option<JointId> {
    let body = joint.body.as_ref().ok()?;
    let origin = draft.note(&joint.name);
    let name = reader.key_of(&joint.name);
    let joining = Joining { name: &joint.name, body, origin };
    let kind = match body.kind {
        JointWord::Revolute => {
            let [a, b] = given::axes(reader, draft, &joining, [AxisKind::Point; 2])?;
            JointKind::Revolute(a, b)
        }
        JointWord::Prismatic => {
            let [a, b] = given::axes(reader, draft, &joining, [AxisKind::Line; 2])?;
            JointKind::Prismatic(a, b)
        }
        JointWord::Weld => {
            let [a, b] = weld_axes(reader, draft, &joining)?;
            JointKind::Weld(a, b)
        }
        JointWord::Slot => {
            let kinds = [AxisKind::Point, AxisKind::Line];
            let [point, line] = given::axes(reader, draft, &joining, kinds)?;
            return is_named.then(|| draft.model.add_slot(&name, origin, point, line));
        }
        JointWord::Gear | JointWord::Belt | JointWord::Rack => {
            rolling::rolling(reader, draft, &joining)?
        }
        JointWord::Cam => cam::cam(reader, draft, &joining)?,
    };
    is_named.then(|| {
        let id = JointId::new(draft.model.joints.len());
        draft.model.joints.push(model::Joint { name, origin, kind, hidden: false });
        id
    })
}

/// The axes of a weld: given ones, drawn ones, or those of both frames.
fn weld_axes(reader: &mut Reader, draft: &mut Draft, joining: &Joining) -> Option<[AxisId; 2]> {
    let body = joining.body;
    let whole = body.at.is_none() && body.ends.iter().all(|end| end.axis.is_none());
    if !whole {
        return given::axes(reader, draft, joining, [AxisKind::Point; 2]);
    }
    if let Some(along) = &body.along {
        let text = "a `weld` has no direction; leave `along` out";
        reader.report.error(Place::at(along.keyword), text);
    }
    let ends = body.ends.each_ref();
    let [a, b] = ends.map(|end| find::link(reader, draft, &end.link));
    let links = [a?, b?];
    joining.check_apart(reader, links)?;
    Some(links.map(|link| draft.drawn_axis(link, DrawnAxis::point([0.0; 2]), joining.origin)))
}
