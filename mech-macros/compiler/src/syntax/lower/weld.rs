//! Links that are one.

use super::draft::Draft;
use super::ends::Joining;
use super::reader::Reader;
use super::{find, given};
use crate::model::{AxisId, AxisKind, DrawnAxis};
use crate::syntax::Place;

/// The axes of a weld: given ones, drawn ones, or those of both frames.
pub(super) fn axes(
    reader: &mut Reader,
    draft: &mut Draft,
    joining: &Joining,
) -> Option<[AxisId; 2]> {
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
