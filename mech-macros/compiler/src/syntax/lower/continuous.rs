//! Coordinates that go on over whole turns.

use super::draft::Draft;
use super::reader::Reader;
use super::{coordinate, find};
use crate::model::{JointId, JointKind, Model};
use crate::syntax::ast::Name;

pub(super) fn lower(reader: &mut Reader, draft: &mut Draft, joints: &[Name]) {
    for name in joints {
        reader.report.next_item();
        let Some(joint) = find::joint(reader, draft, name) else {
            continue;
        };
        if let Some(text) = cannot_go_on(&draft.model, name, joint) {
            reader.report.error(name.place(), text);
        } else {
            draft.model.continuous.push(joint);
        }
    }
    reader.report.next_item();
}

/// Returns the message about a joint whose coordinate cannot go on over whole turns, or does already. A motor may be on it: its value goes
/// on, too, and the motor may be moved.
fn cannot_go_on(model: &Model, name: &Name, joint: JointId) -> Option<String> {
    if let Some(text) = coordinate::missing(model, name, joint, "ask for") {
        return Some(text);
    }
    if let JointKind::Prismatic(..) = model.joint(joint).kind {
        return Some(format!("joint `{name}` slides: its coordinate has no turns; leave this out"));
    }
    if model.continuous.contains(&joint) {
        return Some(format!("`{name}` is continuous already; remove one of the two"));
    }
    (!model.shows_joint(joint)).then(|| {
        format!("`show` leaves the coordinate of `{name}` out; add it there, or leave this out")
    })
}
