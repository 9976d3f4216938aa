//! Joints.

use super::draft::Draft;
use super::name::Referent;
use super::reader::Reader;
use super::{cam, given, rolling, weld};
use crate::model::{self, AxisKind, JointId, JointKind};
use crate::syntax::ast::{Joint, JointWord};

/// What the name of a joint stands for; its axes follow when all links are known.
pub(super) fn declare(reader: &mut Reader, draft: &mut Draft, joint: &Joint) -> Referent {
    let is_taken = draft.claims.take_name(reader, &joint.name, "joint");
    if let Err(error) = &joint.body {
        reader.report.pass_on(error.clone());
    }
    if is_taken {
        Referent::Joint(None)
    } else {
        Referent::Broken
    }
}

/// Whether a joint is a cam, as far as it could be read.
pub(super) fn is_cam(joint: &Joint) -> bool {
    joint
        .body
        .as_ref()
        .is_ok_and(|body| body.kind == JointWord::Cam)
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
    let kind = match body.kind {
        JointWord::Revolute => {
            let [a, b] = given::axes(reader, draft, joint, body, [AxisKind::Point; 2], origin)?;
            JointKind::Revolute(a, b)
        }
        JointWord::Prismatic => {
            let [a, b] = given::axes(reader, draft, joint, body, [AxisKind::Line; 2], origin)?;
            JointKind::Prismatic(a, b)
        }
        JointWord::Weld => {
            let [a, b] = weld::axes(reader, draft, joint, body, origin)?;
            JointKind::Weld(a, b)
        }
        JointWord::Slot => {
            let kinds = [AxisKind::Point, AxisKind::Line];
            let [point, line] = given::axes(reader, draft, joint, body, kinds, origin)?;
            return is_named.then(|| draft.model.add_slot(&name, origin, point, line));
        }
        JointWord::Gear | JointWord::Belt | JointWord::Rack => {
            rolling::rolling(reader, draft, joint, body)?
        }
        JointWord::Cam => cam::cam(reader, draft, joint, body)?,
    };
    is_named.then(|| {
        let id = JointId::new(draft.model.joints.len());
        draft.model.joints.push(model::Joint {
            name,
            origin,
            kind,
            hidden: false,
        });
        id
    })
}
