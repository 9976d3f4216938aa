//! The points whose paths are recorded.

use super::Lowering;
use super::name::{Body, Referent};
use crate::model::{AxisId, AxisKind, LinkId, Trace};
use crate::syntax::Place;
use crate::syntax::ast::{self, End};
use mech_core::colors::INK;

impl Lowering {
    pub(super) fn lower_trace(&mut self, trace: &ast::Trace) {
        let point = self.find_traced(&trace.point);
        let length = self.whole(&trace.length, "the length of a trace", [1, Trace::LONGEST]);
        // Each is looked at, so that the errors of all are reported.
        let plane = trace.plane.as_ref().map(|plane| self.plane(plane));
        let color = trace
            .color
            .as_ref()
            .map_or(Some(INK), |color| self.color(color));
        let (Some(point), Some(length), Some(color)) = (point, length, color) else {
            return;
        };
        let Ok(length) = usize::try_from(length) else {
            return;
        };
        let origin = self.places.note(trace.point.place());
        self.model.traces.push(Trace {
            point,
            length,
            plane: plane.flatten(),
            color,
            origin,
        });
    }

    /// The point that is to be traced, if it can be.
    fn find_traced(&mut self, end: &End) -> Option<AxisId> {
        let Some(name) = &end.axis else {
            self.tell_no_point(end);
            return None;
        };
        let body = self.find_body(&end.link)?;
        let link = body.id;
        let point = self.find_axis(body, name, Some(AxisKind::Point))?;
        let text = if self.model.axis(point).kind == AxisKind::Line {
            let remedy = self.one_of_its_points(body);
            let text = format!("`{end}` is a line; a trace is of a point{remedy}");
            self.report.error(Place::at(name.span()), text);
            return None;
        } else if link == LinkId::GROUND {
            format!("`{end}` does not move: it has no path; trace a point of a moving link")
        } else if self.model.traces.iter().any(|trace| trace.point == point) {
            format!("`{end}` is traced already; remove one of the two")
        } else {
            return Some(point);
        };
        self.report.error(end.place(), text);
        None
    }

    /// Complains about a trace of something that is not a point.
    fn tell_no_point(&mut self, end: &End) {
        match self.look_up(&end.link) {
            Some(Referent::Broken) => {}
            Some(Referent::Use) => {
                self.find_body(&end.link);
            }
            Some(Referent::Joint(_)) => {
                let text = format!("`{end}` is a joint; a trace is of a point: `link.point`");
                self.report.error(end.place(), text);
            }
            Some(Referent::Link(link)) => {
                let remedy = self.one_of_its_points(link);
                let text = format!("`{end}` is a link; a trace is of a point{remedy}");
                self.report.error(end.place(), text);
            }
            None => self.refuse_unknown(&end.link),
        }
    }

    /// What of a link could be traced.
    fn one_of_its_points(&self, link: Body) -> String {
        let name = self.name_of(link);
        match self.axes_of(link, Some(AxisKind::Point)).first() {
            Some(point) if link.id != LinkId::GROUND => format!(", such as `{name}.{point}`"),
            _ if link.id == LinkId::GROUND => " of a moving link".to_owned(),
            _ => format!("; declare one in `{name}`"),
        }
    }

    /// Claims the names of the methods that return traces.
    pub(super) fn claim_trace_methods(&mut self) {
        for trace in self.model.traces.clone() {
            let axis = self.model.axis(trace.point);
            let link = self.model.owner_of(axis);
            let point = axis.own_name();
            let method = format!("{link}_{point}_trace");
            let owner = format!("the trace of `{link}.{point}`");
            let place = self.places.get(trace.origin);
            self.claim_method(method, owner, place);
        }
    }
}
