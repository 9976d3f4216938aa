//! Joints placed in the drawing, and the unnamed axes that they make.

use super::Lowering;
use super::name::Body;
use super::param::Spot;
use crate::model::{AxisId, AxisKind, DrawnAxis, FORWARD, LinkId, Origin};
use crate::syntax::Place;
use crate::syntax::ast::{Clause, End, Joint, JointBody, JointWord, Pair};

impl Lowering {
    /// The axes of these kinds that the drawing puts here on the two links of a joint.
    pub(super) fn drawn_axes(
        &mut self,
        joint: &Joint,
        body: &JointBody,
        at: &Clause<Pair>,
        kinds: [AxisKind; 2],
        origin: Origin,
    ) -> Option<[AxisId; 2]> {
        let links = body.ends.each_ref().map(|end| self.drawn_link(end));
        let (place, at) = (at.value.place, self.spot(&at.value));
        let direction = self.drawn_direction(body, kinds);
        let [a, b] = [links[0]?, links[1]?];
        self.check_apart(joint, body, [a.id, b.id])?;
        let (at, direction) = (at?, direction?);
        let mut axis = |body: Body, kind| {
            let link = body.id;
            // In a drawing the frames of all links are one, those of ports and of the part's own.
            let frame = body.port.map_or(self.similarity, |_| self.frame_of(body));
            let (at, formulas) = self.transform(at, &frame, place)?;
            let (direction, direction_formulas) = self.transform_direction(direction, &frame);
            self.model.links[link.index()].drawn |= link != LinkId::GROUND;
            let drawn = match kind {
                AxisKind::Point => DrawnAxis::point(at),
                AxisKind::Line => DrawnAxis {
                    direction_formulas,
                    ..DrawnAxis::line(at, direction)
                },
            };
            let drawn = DrawnAxis { formulas, ..drawn };
            Some(self.drawn_axis(link, drawn, origin))
        };
        Some([axis(a, kinds[0])?, axis(b, kinds[1])?])
    }

    fn drawn_link(&mut self, end: &End) -> Option<Body> {
        let link = self.find_body(&end.link)?;
        let Some(axis) = &end.axis else {
            return Some(link);
        };
        let name = &end.link;
        let text = format!(
            "`at` places a joint between links; write `{name}` for `{name}.{axis}`, or leave `at` out"
        );
        self.report.error(end.place(), text);
        None
    }

    /// The direction of the line, if there is one.
    fn drawn_direction(&mut self, body: &JointBody, kinds: [AxisKind; 2]) -> Option<Spot> {
        let word = &body.word;
        match (&body.along, kinds.contains(&AxisKind::Line)) {
            (Some(along), true) => self.direction(&along.value),
            (None, false) => Some((FORWARD, [None; 2])),
            (Some(along), false) => {
                let other = match body.kind {
                    JointWord::Revolute => ", or write `prismatic`",
                    _ => "",
                };
                let text = format!("a `{word}` has no direction; leave `along` out{other}");
                self.report.error(Place::at(along.keyword), text);
                None
            }
            (None, true) => {
                let text = format!(
                    "a `{word}` needs a direction; write `along (dx, dy)` after `at (x, y)`"
                );
                self.report.error(Place::at(word.span()), text);
                None
            }
        }
    }

    /// The axis at the origin of a link's frame.
    pub(super) fn frame_axis(&mut self, link: LinkId, origin: Origin) -> AxisId {
        self.drawn_axis(link, DrawnAxis::point([0.0, 0.0]), origin)
    }

    /// The axis that the drawing puts on a link. Joints on one spot share it; only those of the link are looked at.
    fn drawn_axis(&mut self, link: LinkId, drawn: DrawnAxis, origin: Origin) -> AxisId {
        let of_link = self.drawn.entry(link).or_default();
        let is_it = |axis: &&AxisId| drawn.is(self.model.axis(**axis));
        if let Some(&axis) = of_link.iter().find(is_it) {
            return axis;
        }
        let axis = self.model.add_drawn_axis(link, drawn, origin);
        of_link.push(axis);
        axis
    }
}
