//! Joints, between axes or placed in the drawing.

use super::Lowering;
use super::name::{Named, word_for};
use crate::model::{self, AxisId, AxisKind, JointId, JointKind, LinkId, Origin, Ratio};
use crate::syntax::Place;
use crate::syntax::ast::{Clause, End, Expr, ExprKind, Joint, JointBody, JointWord, Size};

impl Lowering {
    /// Enters the name of a joint; the rest comes when all links are known.
    pub(super) fn declare_joint(&mut self, joint: &Joint) {
        if self.claim(&joint.name, "joint") {
            self.names.enter(&joint.name, Named::Joint(None));
        } else {
            self.names.enter(&joint.name, Named::Broken);
            self.nameless.push(self.report.statement());
        }
        if let Err(error) = &joint.body {
            self.report.pass_on(error.clone());
        }
    }

    /// Enters a joint, if it can be understood.
    pub(super) fn lower_joint(&mut self, joint: &Joint) {
        let Ok(body) = &joint.body else {
            return;
        };
        let named = !self.nameless.contains(&self.report.statement());
        let origin = self.note(&joint.name);
        let kind = match body.kind {
            JointWord::Revolute => self.pair_joint(joint, body, AxisKind::Point, origin),
            JointWord::Prismatic => self.pair_joint(joint, body, AxisKind::Line, origin),
            JointWord::Gear => self.gear(joint, body),
            JointWord::Slot | JointWord::Rack | JointWord::Belt | JointWord::Weld => {
                self.not_yet(body)
            }
        };
        if let (Some(kind), true) = (kind, named) {
            let id = JointId::new(self.model.joints.len());
            self.model.joints.push(model::Joint {
                name: joint.name.to_string(),
                origin,
                kind,
            });
            self.names.joint_is(&joint.name, id);
        }
    }

    fn not_yet(&mut self, body: &JointBody) -> Option<JointKind> {
        let text = format!("`{}` joints are not supported yet", body.word);
        self.report.tell(Place::at(body.word.span()), text);
        for end in &body.ends {
            self.check_end(end);
        }
        match &body.size {
            Some(Size::Ratio { parts, .. }) => {
                self.ratio(parts);
            }
            Some(Size::Radius(radius)) => {
                self.positive(radius, "a radius");
            }
            None => {}
        }
        self.check_carrier(body);
        if let Some(at) = &body.at {
            self.pair(&at.value);
        }
        if let Some(along) = &body.along {
            self.direction(&along.value);
        }
        None
    }

    /// A joint of two axes of one kind: given ones, or ones made where the drawing has them.
    fn pair_joint(
        &mut self,
        joint: &Joint,
        body: &JointBody,
        kind: AxisKind,
        origin: Origin,
    ) -> Option<JointKind> {
        let [a, b] = match &body.at {
            Some(at) => self.drawn_axes(joint, body, at, kind, origin)?,
            None => self.given_axes(joint, body, kind)?,
        };
        Some(match kind {
            AxisKind::Point => JointKind::Revolute(a, b),
            AxisKind::Line => JointKind::Prismatic(a, b),
        })
    }

    fn given_axes(
        &mut self,
        joint: &Joint,
        body: &JointBody,
        kind: AxisKind,
    ) -> Option<[AxisId; 2]> {
        if let Some(along) = &body.along {
            let text = "`along` without `at`; write `at (x, y) along (dx, dy)` after two links";
            self.report.tell(Place::at(along.keyword), text);
        }
        let axes = body
            .ends
            .each_ref()
            .map(|end| self.given_axis(body, end, kind));
        let [a, b] = [axes[0]?, axes[1]?];
        self.check_apart(
            joint,
            body,
            [self.model.axis(a).link, self.model.axis(b).link],
        )?;
        Some([a, b])
    }

    fn given_axis(&mut self, body: &JointBody, end: &End, kind: AxisKind) -> Option<AxisId> {
        let link = self.find_link(&end.link)?;
        let Some(name) = &end.axis else {
            self.want_axis(body, end, link, kind);
            return None;
        };
        let axis = self.find_axis(link, name, Some(kind))?;
        let found = self.model.axis(axis).kind;
        if found == kind {
            return Some(axis);
        }
        let (end, found, wanted) = (
            format!("{}.{name}", end.link),
            word_for(found),
            word_for(kind),
        );
        let other = if kind == AxisKind::Point {
            "prismatic"
        } else {
            "revolute"
        };
        let text = format!(
            "`{end}` is a {found}, but `{}` joins {wanted}s; name a {wanted}, or write `{other}`",
            body.word
        );
        self.report.tell(Place::at(name.span()), text);
        None
    }

    /// Complains about a link where one of its axes should be.
    fn want_axis(&mut self, body: &JointBody, end: &End, link: LinkId, kind: AxisKind) {
        let (word, wanted, name) = (&body.word, word_for(kind), &end.link);
        let place = match kind {
            AxisKind::Point => "at (x, y)",
            AxisKind::Line => "at (x, y) along (dx, dy)",
        };
        let example = match self.axes_of(link, Some(kind)).first() {
            Some(axis) => format!("such as `{name}.{axis}`"),
            None => format!("declared in `{name}`"),
        };
        let text = format!(
            "`{word}` joins {wanted}s, but `{name}` is a link; name one of its {wanted}s, {example}, \
             or place a joint of two links with `{place}`"
        );
        self.report.tell(Place::at(name.span()), text);
    }

    fn drawn_axes(
        &mut self,
        joint: &Joint,
        body: &JointBody,
        at: &Clause,
        kind: AxisKind,
        origin: Origin,
    ) -> Option<[AxisId; 2]> {
        let links = body.ends.each_ref().map(|end| self.drawn_link(end));
        let at = self.pair(&at.value);
        let direction = self.drawn_direction(body, kind);
        let links = [links[0]?, links[1]?];
        self.check_apart(joint, body, links)?;
        let (at, direction) = (at?, direction?);
        Some(links.map(|link| self.drawn_axis(link, kind, at, direction, origin)))
    }

    fn drawn_link(&mut self, end: &End) -> Option<LinkId> {
        let link = self.find_link(&end.link)?;
        let Some(axis) = &end.axis else {
            return Some(link);
        };
        let name = &end.link;
        let text = format!(
            "`at` places a joint between links; write `{name}` for `{name}.{axis}`, or leave `at` out"
        );
        self.report.tell(end.place(), text);
        None
    }

    fn drawn_direction(&mut self, body: &JointBody, kind: AxisKind) -> Option<[f64; 2]> {
        match (&body.along, kind) {
            (Some(along), AxisKind::Line) => self.direction(&along.value),
            (None, AxisKind::Point) => Some([1.0, 0.0]),
            (Some(along), AxisKind::Point) => {
                let text = "a `revolute` has no direction; leave `along` out, or write `prismatic`";
                self.report.tell(Place::at(along.keyword), text);
                None
            }
            (None, AxisKind::Line) => {
                let text =
                    "a `prismatic` needs a direction; write `along (dx, dy)` after `at (x, y)`";
                self.report.tell(Place::at(body.word.span()), text);
                None
            }
        }
    }

    /// The axis that the drawing puts here on a link. Joints drawn on one spot share it.
    fn drawn_axis(
        &mut self,
        link: LinkId,
        kind: AxisKind,
        at: [f64; 2],
        direction: [f64; 2],
        origin: Origin,
    ) -> AxisId {
        if let Some(drawn) = self.model.links.get_mut(link.index()) {
            drawn.drawn |= link != LinkId::GROUND;
        }
        let same = |axis: &model::Axis| {
            let drawn = axis.name.is_none() && axis.link == link;
            drawn && axis.kind == kind && axis.at == at && axis.direction == direction
        };
        if let Some(index) = self.model.axes.iter().position(same) {
            return AxisId::new(index);
        }
        let id = AxisId::new(self.model.axes.len());
        self.model.axes.push(model::Axis {
            link,
            name: None,
            origin,
            kind,
            at,
            direction,
        });
        id
    }

    /// A joint must be between two different links.
    fn check_apart(&mut self, joint: &Joint, body: &JointBody, [a, b]: [LinkId; 2]) -> Option<()> {
        if a != b {
            return Some(());
        }
        let [_, second] = &body.ends;
        let text = format!(
            "joint `{}` is between `{}` and itself; name two links",
            joint.name, second.link
        );
        self.report.tell(second.place(), text);
        None
    }

    fn gear(&mut self, joint: &Joint, body: &JointBody) -> Option<JointKind> {
        for clause in [&body.at, &body.along].into_iter().flatten() {
            let text = "a `gear` has no place of its own; its wheels turn where their other joints hold them";
            self.report.tell(Place::at(clause.keyword), text);
        }
        let links = body.ends.each_ref().map(|end| self.wheel(end));
        let ratio = match &body.size {
            Some(Size::Ratio { parts, .. }) => self.ratio(parts),
            _ => None,
        };
        if let Some(Size::Ratio {
            carrier: Some(carrier),
            ..
        }) = &body.size
        {
            self.report.tell(
                Place::at(carrier.keyword),
                "naming the carrier of a gear with `on` is not supported yet",
            );
            self.check_carrier(body);
        }
        let [a, b] = [links[0]?, links[1]?];
        self.check_apart(joint, body, [a, b])?;
        Some(JointKind::Gear {
            a,
            b,
            ratio: ratio?,
        })
    }

    fn check_carrier(&mut self, body: &JointBody) {
        if let Some(Size::Ratio {
            carrier: Some(carrier),
            ..
        }) = &body.size
        {
            self.find_link(&carrier.link);
        }
    }

    fn wheel(&mut self, end: &End) -> Option<LinkId> {
        let link = self.find_link(&end.link)?;
        let Some(axis) = &end.axis else {
            return Some(link);
        };
        let name = &end.link;
        let text = format!("`gear` joins links; write `{name}` for `{name}.{axis}`");
        self.report.tell(end.place(), text);
        None
    }

    fn ratio(&mut self, parts: &[Expr; 2]) -> Option<Ratio> {
        let sizes = parts.each_ref().map(|part| self.size(part));
        let sizes = [sizes[0]?, sizes[1]?];
        if sizes.iter().all(|size| *size < 0.0) {
            let [first, second] = parts;
            let text = "only one wheel of a gear can be a ring; make one of the two positive";
            self.report.tell(first.place.to(second.place), text);
            return None;
        }
        let [a, b] = parts.each_ref().map(teeth);
        Some(match (a, b) {
            (Some(a), Some(b)) => Ratio::Teeth(a, b),
            _ => Ratio::Radii(sizes[0], sizes[1]),
        })
    }

    fn size(&mut self, part: &Expr) -> Option<f64> {
        let size = self.value(part)?;
        if size == 0.0 {
            self.report.tell(
                part.place,
                "a wheel cannot be of size zero; give its teeth or its pitch radius",
            );
            return None;
        }
        if let ExprKind::Integer(digits) = &part.kind
            && digits.parse::<i64>().is_err()
        {
            self.report.tell(
                part.place,
                "no wheel has that many teeth; a pitch radius has a decimal point",
            );
            return None;
        }
        Some(size)
    }
}

/// A number of teeth: an integer as such, with a sign or none. Any other number is a radius.
fn teeth(part: &Expr) -> Option<i64> {
    match &part.kind {
        ExprKind::Integer(digits) => digits.parse().ok(),
        ExprKind::Negative(inner) => teeth(inner).and_then(i64::checked_neg),
        _ => None,
    }
}
