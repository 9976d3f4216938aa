//! Joints placed in the drawing, and the unnamed axes that they make.

use super::draft::Draft;
use super::ends::{Joining, whole_link};
use super::name::Body;
use super::quantity::Spot;
use super::reader::Reader;
use crate::model::{AxisId, AxisKind, DrawnAxis, FORWARD, LinkId};
use crate::syntax::Place;
use crate::syntax::ast::{Clause, JointBody, JointWord, Pair};

/// The axes of these kinds that the drawing puts here on the two links of a joint.
pub(super) fn axes(
    reader: &mut Reader,
    draft: &mut Draft,
    joining: &Joining,
    at: &Clause<Pair>,
    kinds: [AxisKind; 2],
) -> Option<[AxisId; 2]> {
    let why = "`at` places a joint between links";
    let mut whole = |end| whole_link(reader, draft, end, why, ", or leave `at` out");
    let links = joining.body.ends.each_ref().map(&mut whole);
    let (place, at) = (at.value.place, reader.spot(&at.value));
    let direction = drawn_direction(reader, joining.body, kinds);
    let [a, b] = [links[0]?, links[1]?];
    joining.check_apart(reader, [a.id, b.id])?;
    let (at, direction) = (at?, direction?);
    let mut axis = |body: Body, kind| {
        let link = body.id;
        // In a drawing the frames of all links are one, those of ports and of the part's own.
        let frame = body.port.map_or(reader.frame, |_| reader.names.frame_of(body));
        let (at, formulas) = reader.transform(at, frame, place)?;
        let (direction, direction_formulas) = frame.direction(direction, reader.formulas());
        draft.model.links[link.index()].drawn |= link != LinkId::GROUND;
        let drawn = match kind {
            AxisKind::Point => DrawnAxis::point(at),
            AxisKind::Line => DrawnAxis { direction_formulas, ..DrawnAxis::line(at, direction) },
        };
        let drawn = DrawnAxis { formulas, ..drawn };
        Some(draft.drawn_axis(link, drawn, joining.origin))
    };
    Some([axis(a, kinds[0])?, axis(b, kinds[1])?])
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
            reader.report.refuse(Place::at(along.keyword), text)
        }
        (None, true) => {
            let text =
                format!("a `{word}` needs a direction; write `along (dx, dy)` after `at (x, y)`");
            reader.report.refuse(Place::at(word.span()), text)
        }
    }
}
