//! Joints placed in the drawing, and the unnamed axes that they make.

use super::draft::Draft;
use super::ends::check_apart;
use super::find;
use super::name::Body;
use super::quantity::Spot;
use super::reader::Reader;
use crate::model::{AxisId, AxisKind, DrawnAxis, FORWARD, LinkId, Origin};
use crate::syntax::Place;
use crate::syntax::ast::{Clause, End, Joint, JointBody, JointWord, Pair};

/// The axes of these kinds that the drawing puts here on the two links of a joint.
pub(super) fn axes(
    reader: &mut Reader,
    draft: &mut Draft,
    joint: &Joint,
    body: &JointBody,
    at: &Clause<Pair>,
    kinds: [AxisKind; 2],
    origin: Origin,
) -> Option<[AxisId; 2]> {
    let links = body
        .ends
        .each_ref()
        .map(|end| drawn_link(reader, draft, end));
    let (place, at) = (at.value.place, reader.spot(&at.value));
    let direction = drawn_direction(reader, body, kinds);
    let [a, b] = [links[0]?, links[1]?];
    check_apart(reader, joint, body, [a.id, b.id])?;
    let (at, direction) = (at?, direction?);
    let mut axis = |body: Body, kind| {
        let link = body.id;
        // In a drawing the frames of all links are one, those of ports and of the part's own.
        let frame = body
            .port
            .map_or(reader.frame, |_| reader.names.frame_of(body));
        let (at, formulas) = reader.transform(at, &frame, place)?;
        let (direction, direction_formulas) = frame.direction(direction, reader.formulas());
        draft.model.links[link.index()].drawn |= link != LinkId::GROUND;
        let drawn = match kind {
            AxisKind::Point => DrawnAxis::point(at),
            AxisKind::Line => DrawnAxis {
                direction_formulas,
                ..DrawnAxis::line(at, direction)
            },
        };
        let drawn = DrawnAxis { formulas, ..drawn };
        Some(draft.drawn_axis(link, drawn, origin))
    };
    Some([axis(a, kinds[0])?, axis(b, kinds[1])?])
}

fn drawn_link(reader: &mut Reader, draft: &Draft, end: &End) -> Option<Body> {
    let link = find::body(reader, draft, &end.link)?;
    let Some(axis) = &end.axis else {
        return Some(link);
    };
    let name = &end.link;
    let text = format!(
        "`at` places a joint between links; write `{name}` for `{name}.{axis}`, or leave `at` out"
    );
    reader.report.error(end.place(), text);
    None
}

/// The direction of the line, if there is one.
fn drawn_direction(reader: &mut Reader, body: &JointBody, kinds: [AxisKind; 2]) -> Option<Spot> {
    let word = &body.word;
    match (&body.along, kinds.contains(&AxisKind::Line)) {
        (Some(along), true) => reader.direction(&along.value),
        (None, false) => Some((FORWARD, [None; 2])),
        (Some(along), false) => {
            let other = match body.kind {
                JointWord::Revolute => ", or write `prismatic`",
                _ => "",
            };
            let text = format!("a `{word}` has no direction; leave `along` out{other}");
            reader.report.error(Place::at(along.keyword), text);
            None
        }
        (None, true) => {
            let text =
                format!("a `{word}` needs a direction; write `along (dx, dy)` after `at (x, y)`");
            reader.report.error(Place::at(word.span()), text);
            None
        }
    }
}
