//! Joints between the axes that links have.

use super::draft::Draft;
use super::ends::Joining;
use super::name::{Body, Referent, word_for};
use super::reader::Reader;
use super::{drawn, find};
use crate::model::{AxisId, AxisKind};
use crate::syntax::Place;
use crate::syntax::ast::{End, JointBody, JointWord};

const POINT: Option<AxisKind> = Some(AxisKind::Point);
const WITHOUT_PLACE: &str =
    "`along` without `at`; write `at (x, y) along (dx, dy)` after two links";
const LINE: Option<AxisKind> = Some(AxisKind::Line);

/// Two axes of these kinds: given ones, or ones made where the drawing has them.
pub(super) fn axes(
    reader: &mut Reader,
    draft: &mut Draft,
    joining: &Joining,
    kinds: [AxisKind; 2],
) -> Option<[AxisId; 2]> {
    match &joining.body.at {
        Some(at) => drawn::axes(reader, draft, joining, at, kinds),
        None => given_axes(reader, draft, joining, kinds),
    }
}

fn given_axes(
    reader: &mut Reader,
    draft: &Draft,
    joining: &Joining,
    kinds: [AxisKind; 2],
) -> Option<[AxisId; 2]> {
    let body = joining.body;
    let found = body.ends.each_ref().map(|end| kind_of(reader, draft, end));
    let axes = if is_of_links(reader, body) {
        refuse_links(reader, body);
        return None;
    } else if body.kind == JointWord::Slot && found == [LINE, POINT] {
        refuse_swapped(reader, body);
        [None; 2]
    } else if let ([Some(is), Some(other)], [wanted, second]) = (found, kinds)
        && is == other
        && wanted == second
        && is != wanted
    {
        refuse_both(reader, body, [is, wanted], found);
        [None; 2]
    } else {
        let [first, second] = &body.ends;
        [
            given_axis(reader, draft, body, first, kinds[0], found),
            given_axis(reader, draft, body, second, kinds[1], found),
        ]
    };
    if let Some(along) = &body.along {
        let text = match body.kind {
            JointWord::Weld => "a `weld` has no direction; leave `along` out",
            _ => WITHOUT_PLACE,
        };
        reader.report.error(Place::at(along.keyword), text);
    }
    let [a, b] = [axes[0]?, axes[1]?];
    joining.check_apart(reader, [a, b].map(|axis| draft.model.axis(axis).link))?;
    Some([a, b])
}

/// Whether an end is a point or a line, without a word if it is neither.
fn kind_of(reader: &mut Reader, draft: &Draft, end: &End) -> Option<AxisKind> {
    let Referent::Link(link) = find::look_up(reader, &end.link)? else {
        return None;
    };
    let name = end.axis.as_ref()?.to_string();
    let axis = reader.names.axis_of(&draft.model, link, &name)?;
    Some(draft.model.axis(axis).kind)
}

/// Whether a joint of axes has two links for its ends.
fn is_of_links(reader: &mut Reader, body: &JointBody) -> bool {
    let mut is_link = |end: &End| {
        let referent = find::look_up(reader, &end.link);
        end.axis.is_none() && matches!(referent, Some(Referent::Link(_)))
    };
    body.kind != JointWord::Weld && body.ends.iter().all(&mut is_link)
}

/// Complains about a joint of links without a place.
fn refuse_links(reader: &mut Reader, body: &JointBody) {
    if let Some(along) = &body.along {
        return reader.report.error(Place::at(along.keyword), WITHOUT_PLACE);
    }
    let ([first, second], word) = (&body.ends, &body.word);
    let (clauses, axes) = match body.kind {
        JointWord::Revolute => ("at (x, y)", "a point of each"),
        JointWord::Slot => {
            ("at (x, y) along (dx, dy)", "a point of the first and a line of the second")
        }
        _ => ("at (x, y) along (dx, dy)", "a line of each"),
    };
    let text = format!(
        "`{first}` and `{second}` are links, so this `{word}` needs a place; write `{clauses}` after the brackets, or name {axes}"
    );
    reader.report.error(first.place().to(second.place()), text);
}

/// Complains about a slot whose line comes before its point.
fn refuse_swapped(reader: &mut Reader, body: &JointBody) {
    let [line, point] = &body.ends;
    let text =
        format!("a `slot` takes the point first, then the line; write `slot({point}, {line})`");
    reader.report.error(line.place().to(point.place()), text);
}

/// Complains about two axes that are both of one kind where another is wanted.
fn refuse_both(
    reader: &mut Reader,
    body: &JointBody,
    kinds: [AxisKind; 2],
    found: [Option<AxisKind>; 2],
) {
    let [is, wanted] = kinds.map(word_for);
    let [first, second] = &body.ends;
    let text = format!(
        "`{first}` and `{second}` are {is}s, but `{}` joins {wanted}s; name {wanted}s{}",
        body.word,
        other_joint(body, found)
    );
    reader.report.error(first.place().to(second.place()), text);
}

/// The axis of an end, which must be of this kind; both ends are of those that were found.
fn given_axis(
    reader: &mut Reader,
    draft: &Draft,
    body: &JointBody,
    end: &End,
    kind: AxisKind,
    found: [Option<AxisKind>; 2],
) -> Option<AxisId> {
    let link = find::body(reader, draft, &end.link)?;
    let Some(name) = &end.axis else {
        want_axis(reader, draft, body, end, link, kind);
        return None;
    };
    let axis = find::axis(reader, draft, link, name, Some(kind))?;
    let is = draft.model.axis(axis).kind;
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
    reader.report.refuse(Place::at(name.span()), text)
}

/// Complains about a link where one of its axes should be.
fn want_axis(
    reader: &mut Reader,
    draft: &Draft,
    body: &JointBody,
    end: &End,
    link: Body,
    kind: AxisKind,
) {
    let (word, wanted, name) = (&body.word, word_for(kind), &end.link);
    let [first, second] = body.ends.each_ref().map(|end| &end.link);
    let drawn = "place a joint of two links with";
    let other = match body.kind {
        JointWord::Weld => format!("join the whole links with `weld({first}, {second})`"),
        JointWord::Revolute => format!("{drawn} `at (x, y)`"),
        _ => format!("{drawn} `at (x, y) along (dx, dy)`"),
    };
    let example = match reader.names.axes_of(&draft.model, link, Some(kind)).first() {
        Some(axis) => format!("such as `{name}.{axis}`"),
        None => format!("declared in `{name}`"),
    };
    let text = format!(
        "`{word}` joins {}, but `{name}` is a link; name one of its {wanted}s, {example}, or {other}",
        operands_of(body.kind)
    );
    reader.report.error(name.place(), text);
}

/// Returns the words for the axes that a joint takes.
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
