//! Coordinates of joints.

use super::rolling;
use super::similarity::Similarity;
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
