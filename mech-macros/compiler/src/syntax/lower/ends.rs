//! What joints are between.

use super::reader::Reader;
use crate::model::LinkId;
use crate::syntax::ast::{Joint, JointBody};

/// A joint must be between two different links.
pub(super) fn check_apart(
    reader: &mut Reader,
    joint: &Joint,
    body: &JointBody,
    [a, b]: [LinkId; 2],
) -> Option<()> {
    if a != b {
        return Some(());
    }
    let [_, second] = &body.ends;
    let text = format!(
        "joint `{}` is between `{}` and itself; name two links",
        joint.name, second.link
    );
    reader.report.error(second.place(), text);
    None
}
