//! Coordinates of joints.

use super::draft::Draft;
use super::reader::Reader;
use super::similarity::Similarity;
use super::{find, rolling};
use crate::model::{JointId, JointKind, Model};
use crate::syntax::ast::Name;

/// Returns the message about a joint that has no coordinate that somebody could give or show.
pub(super) fn missing(model: &Model, name: &Name, joint: JointId, verb: &str) -> Option<String> {
    let kind = model.joint(joint).kind;
    let (word, remedy) = match (rolling::word_for(kind), kind) {
        (Some(word), JointKind::Rack { .. }) => {
            (word, format!("{verb} that of the joint of its pinion or its bar"))
        }
        (Some(word), JointKind::Cam { shaft, .. }) => {
            (word, format!("{verb} that of its shaft, `{}`", model.joint(shaft).name))
        }
        (Some(word), _) => (word, format!("{verb} that of the joint of one of its wheels")),
        (None, JointKind::Weld(..)) => ("weld", "leave this out".to_owned()),
        (None, _) => return None,
    };
    Some(format!("`{name}` is a {word}, which has no coordinate; {remedy}"))
}

/// Whether a joint was placed by `at`.
pub(super) fn is_drawn(model: &Model, joint: JointId) -> bool {
    match model.joint(joint).kind {
        JointKind::Revolute(axis, _) | JointKind::Prismatic(axis, _) => {
            model.axis(axis).name.is_none()
        }
        _ => false,
    }
}

/// The coordinate that a joint has where a part gives it this one.
pub(super) fn own(model: &Model, frame: &Similarity, joint: JointId, value: f64) -> f64 {
    match model.joint(joint).kind {
        JointKind::Revolute(..) => frame.sense() * value,
        _ => frame.start_scale() * value,
    }
}

/// The joints whose coordinates go on over whole turns.
pub(super) fn lower_continuous(reader: &mut Reader, draft: &mut Draft, joints: &[Name]) {
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
    if let Some(text) = missing(model, name, joint, "ask for") {
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
