//! Links that are one.

use super::draft::Draft;
use super::ends::check_apart;
use super::reader::Reader;
use super::{find, given};
use crate::model::{AxisId, AxisKind, DrawnAxis, Origin};
use crate::syntax::Place;
use crate::syntax::ast::{Joint, JointBody};

/// The axes of a weld: given ones, drawn ones, or those of both frames.
pub(super) fn axes(
    reader: &mut Reader,
    draft: &mut Draft,
    joint: &Joint,
    body: &JointBody,
    origin: Origin,
) -> Option<[AxisId; 2]> {
    let whole = body.at.is_none() && body.ends.iter().all(|end| end.axis.is_none());
    if !whole {
        return given::axes(reader, draft, joint, body, [AxisKind::Point; 2], origin);
    }
    if let Some(along) = &body.along {
        let text = "a `weld` has no direction; leave `along` out";
        reader.report.error(Place::at(along.keyword), text);
    }
    let [a, b] = body
        .ends
        .each_ref()
        .map(|end| find::link(reader, draft, &end.link));
    let links = [a?, b?];
    check_apart(reader, joint, body, links)?;
    Some(links.map(|link| draft.drawn_axis(link, DrawnAxis::point([0.0; 2]), origin)))
}
