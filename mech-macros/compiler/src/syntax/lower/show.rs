//! The statement `show`.

use super::draft::Draft;
use super::name::{Body, Referent};
use super::reader::Reader;
use super::{coordinate, find};
use crate::model::{AxisKind, LinkId, Model, Shown};
use crate::syntax::Place;
use crate::syntax::ast::{End, Name};
use proc_macro2::{Ident, Span};

pub(super) fn lower(reader: &mut Reader, draft: &mut Draft, keyword: Span, what: &[End]) {
    if draft.model.effects.needs_actions() {
        let text = "forces come from everything that moves, shown or not; leave `show` out, or the effects `force` and `dynamics`";
        return reader.report.error(Place::at(keyword), text);
    }
    let mut shown: Vec<(Place, Shown)> = Vec::new();
    for end in what {
        reader.report.next_item();
        let Some(one) = find_shown(reader, draft, end) else {
            continue;
        };
        if let Some(text) = again(&draft.model, end, one, &shown) {
            reader.report.error(end.place(), text);
        } else {
            shown.push((end.place(), one));
        }
    }
    reader.report.next_item();
    tell_points(reader, &draft.model, &shown);
    if shown.len() < what.len() || draft.model.show.is_some() {
        return;
    }
    draft.model.show = Some(shown.into_iter().map(|(_, one)| one).collect());
    if draft.model.asked_links().is_empty() {
        reader.report.error(
                Place::at(keyword),
                "nothing of this has to be computed: it is what the motors are given; show what they move, or leave this out",
            );
    }
}

/// Finds a thing that is to be shown; reports it if it cannot be.
fn find_shown(reader: &mut Reader, draft: &Draft, end: &End) -> Option<Shown> {
    match (find::look_up(reader, &end.link), &end.axis) {
        (Some(Referent::Broken), _) => None,
        (None, None) => {
            find::refuse_unknown(reader, &end.link);
            None
        }
        (Some(Referent::Joint(joint)), None) => {
            let joint = joint?;
            if let Some(text) = coordinate::missing(&draft.model, &end.link, joint, "show") {
                return reader.report.refuse(end.place(), text);
            }
            Some(Shown::Joint(joint))
        }
        (_, axis) => {
            let body = find::body(reader, draft, &end.link)?;
            let link = body.id;
            let shown = match axis {
                None => Shown::Link(link),
                Some(axis) => shown_point(reader, draft, body, &end.link, axis)?,
            };
            if link == LinkId::GROUND {
                let text =
                    format!("`{end}` does not move: there is nothing to compute; leave this out");
                return reader.report.refuse(end.place(), text);
            }
            Some(shown)
        }
    }
}

fn shown_point(
    reader: &mut Reader,
    draft: &Draft,
    link: Body,
    link_name: &Name,
    name: &Ident,
) -> Option<Shown> {
    let axis = find::axis(reader, draft, link, name, Some(AxisKind::Point))?;
    if draft.model.axis(axis).kind == AxisKind::Line {
        let remedy = match link.id {
            LinkId::GROUND => "leave this out".to_owned(),
            _ => format!("show its link, `{link_name}`"),
        };
        let text = format!("`{link_name}.{name}` is a line; {remedy}");
        return reader.report.refuse(Place::at(name.span()), text);
    }
    Some(Shown::Point(axis))
}

/// Returns the message about something that is shown already.
fn again(model: &Model, end: &End, one: Shown, before: &[(Place, Shown)]) -> Option<String> {
    let known = |wanted: Shown| before.iter().any(|(_, shown)| *shown == wanted);
    if known(one) {
        return Some(format!("`{end}` is shown already; remove one of the two"));
    }
    match one {
        Shown::Point(point) if known(Shown::Link(model.axis(point).link)) => {
            Some(format!("`{end}` is shown with its link already; leave this out"))
        }
        _ => None,
    }
}

/// Complains about points that are shown before their links.
fn tell_points(reader: &mut Reader, model: &Model, shown: &[(Place, Shown)]) {
    for (place, one) in shown {
        let Shown::Point(point) = *one else {
            continue;
        };
        let axis = model.axis(point);
        if shown.iter().any(|(_, one)| *one == Shown::Link(axis.link)) {
            let link = &model.link(axis.link).name;
            let name = axis.own_name();
            let text = format!("`{link}.{name}` is shown with its link already; leave this out");
            reader.report.error(*place, text);
        }
    }
}
