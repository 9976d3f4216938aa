//! What is asked for.

use super::Lowering;
use super::name::{Body, Referent};
use crate::model::{AxisKind, LinkId, Shown};
use crate::syntax::Place;
use crate::syntax::ast::{End, Name};
use proc_macro2::{Ident, Span};

impl Lowering {
    pub(super) fn lower_show(&mut self, keyword: Span, what: &[End]) {
        self.single(keyword, "show", "put everything into the first");
        if self.model.effects.needs_actions() {
            let text = "forces come from everything that moves, shown or not; leave `show` out, or the effects `force` and `dynamics`";
            return self.report.error(Place::at(keyword), text);
        }
        let mut shown: Vec<(Place, Shown)> = Vec::new();
        for end in what {
            self.report.next_item();
            let Some(one) = self.find_shown(end) else {
                continue;
            };
            if let Some(text) = self.again(end, one, &shown) {
                self.report.error(end.place(), text);
            } else {
                shown.push((end.place(), one));
            }
        }
        self.report.next_item();
        self.tell_points_shown_before_their_links(&shown);
        if shown.len() < what.len() || self.model.show.is_some() {
            return;
        }
        self.model.show = Some(shown.into_iter().map(|(_, one)| one).collect());
        if self.model.asked_links().is_empty() {
            self.report.error(
                Place::at(keyword),
                "nothing of this has to be computed: it is what the motors are given; show what they move, or leave this out",
            );
        }
    }

    /// What is to be shown, if it can be.
    fn find_shown(&mut self, end: &End) -> Option<Shown> {
        match (self.look_up(&end.link), &end.axis) {
            (Some(Referent::Broken), _) => None,
            (None, None) => {
                self.refuse_unknown(&end.link);
                None
            }
            (Some(Referent::Joint(joint)), None) => {
                let joint = joint?;
                if let Some(text) = self.no_coordinate(&end.link, joint, "show") {
                    self.report.error(end.place(), text);
                    return None;
                }
                Some(Shown::Joint(joint))
            }
            (_, axis) => {
                let body = self.find_body(&end.link)?;
                let link = body.id;
                let shown = match axis {
                    None => Shown::Link(link),
                    Some(axis) => self.shown_point(body, &end.link, axis)?,
                };
                if link == LinkId::GROUND {
                    let text = format!(
                        "`{end}` does not move: there is nothing to compute; leave this out"
                    );
                    self.report.error(end.place(), text);
                    return None;
                }
                Some(shown)
            }
        }
    }

    fn shown_point(&mut self, link: Body, link_name: &Name, name: &Ident) -> Option<Shown> {
        let axis = self.find_axis(link, name, Some(AxisKind::Point))?;
        if self.model.axis(axis).kind == AxisKind::Line {
            let remedy = match link.id {
                LinkId::GROUND => "leave this out".to_owned(),
                _ => format!("show its link, `{link_name}`"),
            };
            let text = format!("`{link_name}.{name}` is a line; {remedy}");
            self.report.error(Place::at(name.span()), text);
            return None;
        }
        Some(Shown::Point(axis))
    }

    /// What to say about something that is shown already.
    fn again(&self, end: &End, one: Shown, before: &[(Place, Shown)]) -> Option<String> {
        let known = |wanted: Shown| before.iter().any(|(_, shown)| *shown == wanted);
        if known(one) {
            return Some(format!("`{end}` is shown already; remove one of the two"));
        }
        match one {
            Shown::Point(point) if known(Shown::Link(self.model.axis(point).link)) => Some(
                format!("`{end}` is shown with its link already; leave this out"),
            ),
            _ => None,
        }
    }

    fn tell_points_shown_before_their_links(&mut self, shown: &[(Place, Shown)]) {
        let links: Vec<LinkId> = shown
            .iter()
            .filter_map(|(_, one)| match one {
                Shown::Link(link) => Some(*link),
                Shown::Point(_) | Shown::Joint(_) => None,
            })
            .collect();
        for (place, one) in shown {
            if let Shown::Point(point) = one {
                let axis = self.model.axis(*point);
                if links.contains(&axis.link) {
                    let link = &self.model.link(axis.link).name;
                    let name = axis.own_name();
                    let text =
                        format!("`{link}.{name}` is shown with its link already; leave this out");
                    self.report.error(*place, text);
                }
            }
        }
    }
}
