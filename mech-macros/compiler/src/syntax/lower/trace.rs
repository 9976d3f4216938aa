//! The points whose paths are recorded.

use super::draft::Draft;
use super::name::{Body, Referent};
use super::reader::Reader;
use super::report::Report;
use super::{find, link};
use crate::model::{AxisId, AxisKind, LinkId, Trace};
use crate::syntax::Place;
use crate::syntax::ast::{self, End};
use mech_core::colors::INK;

pub(super) fn lower(reader: &mut Reader, draft: &mut Draft, trace: &ast::Trace) {
    let point = find_traced(reader, draft, &trace.point);
    let length = reader.whole(&trace.length, "the length of a trace", [1, Trace::LONGEST]);
    // Each is looked at, so that the errors of all are reported.
    let plane = trace.plane.as_ref();
    let plane = plane.map(|plane| link::read_plane(reader, plane));
    let color = trace.color.as_ref();
    let color = color.map_or(Some(INK), |color| link::read_color(reader, color));
    let (Some(point), Some(length), Some(color)) = (point, length, color) else {
        return;
    };
    let Ok(length) = usize::try_from(length) else {
        return;
    };
    let origin = draft.places.note(trace.point.place());
    draft.model.traces.push(Trace { point, length, plane: plane.flatten(), color, origin });
}

/// The point that is to be traced, if it can be.
fn find_traced(reader: &mut Reader, draft: &Draft, end: &End) -> Option<AxisId> {
    let Some(name) = &end.axis else {
        tell_no_point(reader, draft, end);
        return None;
    };
    let body = find::body(reader, draft, &end.link)?;
    let link = body.id;
    let point = find::axis(reader, draft, body, name, Some(AxisKind::Point))?;
    let text = if draft.model.axis(point).kind == AxisKind::Line {
        let remedy = one_of_its_points(reader, draft, body);
        let text = format!("`{end}` is a line; a trace is of a point{remedy}");
        return reader.report.refuse(Place::at(name.span()), text);
    } else if link == LinkId::GROUND {
        format!("`{end}` does not move: it has no path; trace a point of a moving link")
    } else if draft.model.traces.iter().any(|trace| trace.point == point) {
        format!("`{end}` is traced already; remove one of the two")
    } else {
        return Some(point);
    };
    reader.report.refuse(end.place(), text)
}

/// Complains about a trace of something that is not a point.
fn tell_no_point(reader: &mut Reader, draft: &Draft, end: &End) {
    match find::look_up(reader, &end.link) {
        Some(Referent::Broken) => {}
        Some(Referent::Use) => {
            find::body(reader, draft, &end.link);
        }
        Some(Referent::Joint(_)) => {
            let text = format!("`{end}` is a joint; a trace is of a point: `link.point`");
            reader.report.error(end.place(), text);
        }
        Some(Referent::Link(link)) => {
            let remedy = one_of_its_points(reader, draft, link);
            let text = format!("`{end}` is a link; a trace is of a point{remedy}");
            reader.report.error(end.place(), text);
        }
        None => find::refuse_unknown(reader, &end.link),
    }
}

/// Returns the remedy for a link that stands where a point is meant: one of its points.
pub(super) fn one_of_its_points(reader: &Reader, draft: &Draft, link: Body) -> String {
    let name = reader.names.name_of(&draft.model, link);
    let points = reader.names.axes_of(&draft.model, link, Some(AxisKind::Point));
    match points.first() {
        Some(point) if link.id != LinkId::GROUND => format!(", such as `{name}.{point}`"),
        _ if link.id == LinkId::GROUND => " of a moving link".to_owned(),
        _ => format!("; declare one in `{name}`"),
    }
}

/// Claims the names of the methods that return traces.
pub(super) fn take_methods(draft: &mut Draft, report: &mut Report) {
    for trace in draft.model.traces.clone() {
        let axis = draft.model.axis(trace.point);
        let link = draft.model.owner_of(axis);
        let point = axis.own_name();
        let method = format!("{link}_{point}_trace");
        let owner = format!("the trace of `{link}.{point}`");
        let place = draft.places.get(trace.origin);
        draft.claims.take(method, owner, place, report);
    }
}
