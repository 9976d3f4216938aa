//! Joints: their names, and those between axes.

use super::Lowering;
use super::name::{Body, Referent, word_for};
use crate::model::{self, AxisId, AxisKind, JointId, JointKind, LinkId, Origin};
use crate::syntax::Place;
use crate::syntax::ast::{End, Joint, JointBody, JointWord};

const POINT: Option<AxisKind> = Some(AxisKind::Point);
const LINE: Option<AxisKind> = Some(AxisKind::Line);

impl Lowering {
    /// Enters the name of a joint; its axes follow when all links are known.
    pub(super) fn declare_joint(&mut self, joint: &Joint) {
        if self.claim(&joint.name, "joint") {
            let key = self.key_of(&joint.name);
            self.names.enter(key, Referent::Joint(None));
        } else {
            let key = self.key_of(&joint.name);
            self.names.enter(key, Referent::Broken);
            self.nameless.push(self.statement());
        }
        match &joint.body {
            Ok(body) if body.kind == JointWord::Cam => self.cams.push(self.key_of(&joint.name)),
            Ok(_) => {}
            Err(error) => self.report.pass_on(error.clone()),
        }
    }

    /// Enters a joint, if it can be understood.
    pub(super) fn lower_joint(&mut self, joint: &Joint) {
        let Ok(body) = &joint.body else {
            return;
        };
        // A cam refers to joints that may be declared after it.
        if body.kind == JointWord::Cam {
            return;
        }
        if let Some(id) = self.enter_joint(joint, body) {
            self.names.joint_is(&self.key_of(&joint.name), id);
        }
    }

    /// Enters a cam, if it can be understood.
    pub(super) fn lower_cam(&mut self, joint: &Joint) {
        if let Ok(body) = &joint.body
            && body.kind == JointWord::Cam
            && let Some(id) = self.enter_joint(joint, body)
        {
            self.names.joint_is(&self.key_of(&joint.name), id);
        }
    }

    fn enter_joint(&mut self, joint: &Joint, body: &JointBody) -> Option<JointId> {
        let named = !self.nameless.contains(&self.statement());
        let origin = self.note(&joint.name);
        let name = self.key_of(&joint.name);
        let kind = match body.kind {
            JointWord::Revolute => {
                let [a, b] = self.axes(joint, body, [AxisKind::Point; 2], origin)?;
                JointKind::Revolute(a, b)
            }
            JointWord::Prismatic => {
                let [a, b] = self.axes(joint, body, [AxisKind::Line; 2], origin)?;
                JointKind::Prismatic(a, b)
            }
            JointWord::Weld => {
                let [a, b] = self.weld_axes(joint, body, origin)?;
                JointKind::Weld(a, b)
            }
            JointWord::Slot => {
                let kinds = [AxisKind::Point, AxisKind::Line];
                let [point, line] = self.axes(joint, body, kinds, origin)?;
                return named.then(|| self.model.add_slot(&name, origin, point, line));
            }
            JointWord::Gear | JointWord::Belt | JointWord::Rack => self.rolling(joint, body)?,
            JointWord::Cam => self.cam(joint, body)?,
        };
        named.then(|| {
            let id = JointId::new(self.model.joints.len());
            self.model.joints.push(model::Joint {
                name,
                origin,
                kind,
                hidden: false,
            });
            id
        })
    }

    /// Two axes of these kinds: given ones, or ones made where the drawing has them.
    pub(super) fn axes(
        &mut self,
        joint: &Joint,
        body: &JointBody,
        kinds: [AxisKind; 2],
        origin: Origin,
    ) -> Option<[AxisId; 2]> {
        match &body.at {
            Some(at) => self.drawn_axes(joint, body, at, kinds, origin),
            None => self.given_axes(joint, body, kinds),
        }
    }

    fn given_axes(
        &mut self,
        joint: &Joint,
        body: &JointBody,
        kinds: [AxisKind; 2],
    ) -> Option<[AxisId; 2]> {
        let found = body.ends.each_ref().map(|end| self.kind_of(end));
        let axes = if body.kind == JointWord::Slot && found == [LINE, POINT] {
            self.refuse_swapped(body);
            [None; 2]
        } else {
            let [first, second] = &body.ends;
            [
                self.given_axis(body, first, kinds[0], found),
                self.given_axis(body, second, kinds[1], found),
            ]
        };
        if let Some(along) = &body.along {
            let text = match body.kind {
                JointWord::Weld => "a `weld` has no direction; leave `along` out",
                _ => "`along` without `at`; write `at (x, y) along (dx, dy)` after two links",
            };
            self.report.error(Place::at(along.keyword), text);
        }
        let [a, b] = [axes[0]?, axes[1]?];
        self.check_apart(
            joint,
            body,
            [self.model.axis(a).link, self.model.axis(b).link],
        )?;
        Some([a, b])
    }

    /// Whether an end is a point or a line, without a word if it is neither.
    fn kind_of(&mut self, end: &End) -> Option<AxisKind> {
        let Referent::Link(link) = self.look_up(&end.link)? else {
            return None;
        };
        let axis = self.axis_of(link, &end.axis.as_ref()?.to_string())?;
        Some(self.model.axis(axis).kind)
    }

    /// Complains about a slot whose line comes before its point.
    fn refuse_swapped(&mut self, body: &JointBody) {
        let [line, point] = &body.ends;
        let text =
            format!("a `slot` takes the point first, then the line; write `slot({point}, {line})`");
        self.report.error(line.place().to(point.place()), text);
    }

    /// The axis of an end, which must be of this kind; both ends are of those that were found.
    fn given_axis(
        &mut self,
        body: &JointBody,
        end: &End,
        kind: AxisKind,
        found: [Option<AxisKind>; 2],
    ) -> Option<AxisId> {
        let link = self.find_body(&end.link)?;
        let Some(name) = &end.axis else {
            self.want_axis(body, end, link, kind);
            return None;
        };
        let axis = self.find_axis(link, name, Some(kind))?;
        let is = self.model.axis(axis).kind;
        if is == kind {
            return Some(axis);
        }
        let (is, wanted) = (word_for(is), word_for(kind));
        let text = format!(
            "`{end}` is a {is}, but `{}` joins {}; name a {wanted}{}",
            body.word,
            operands_of(body.kind),
            other_joint(body, found)
        );
        self.report.error(Place::at(name.span()), text);
        None
    }

    /// Complains about a link where one of its axes should be.
    fn want_axis(&mut self, body: &JointBody, end: &End, link: Body, kind: AxisKind) {
        let (word, wanted, name) = (&body.word, word_for(kind), &end.link);
        let [first, second] = body.ends.each_ref().map(|end| &end.link);
        let drawn = "place a joint of two links with";
        let other = match body.kind {
            JointWord::Weld => format!("join the whole links with `weld({first}, {second})`"),
            JointWord::Revolute => format!("{drawn} `at (x, y)`"),
            _ => format!("{drawn} `at (x, y) along (dx, dy)`"),
        };
        let example = match self.axes_of(link, Some(kind)).first() {
            Some(axis) => format!("such as `{name}.{axis}`"),
            None => format!("declared in `{name}`"),
        };
        let text = format!(
            "`{word}` joins {}, but `{name}` is a link; name one of its {wanted}s, {example}, or {other}",
            operands_of(body.kind)
        );
        self.report.error(name.place(), text);
    }

    /// A joint must be between two different links.
    pub(super) fn check_apart(
        &mut self,
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
        self.report.error(second.place(), text);
        None
    }
}

/// What a joint of axes takes.
fn operands_of(kind: JointWord) -> &'static str {
    match kind {
        JointWord::Prismatic => "lines",
        JointWord::Slot => "a point to a line",
        _ => "points",
    }
}

/// The end of a message about axes of the wrong kind: the joint that takes those that were found, if there is one.
fn other_joint(body: &JointBody, found: [Option<AxisKind>; 2]) -> String {
    let [first, second] = &body.ends;
    match (body.kind, found) {
        (JointWord::Weld, _) => String::new(),
        (_, [POINT, LINE]) => format!(", or write `slot({first}, {second})`"),
        (_, [LINE, POINT]) => format!(", or write `slot({second}, {first})`"),
        (_, [POINT, POINT]) | (JointWord::Prismatic, _) => ", or write `revolute`".to_owned(),
        (_, [LINE, LINE]) | (JointWord::Revolute, _) => ", or write `prismatic`".to_owned(),
        _ => String::new(),
    }
}
