//! How the mechanism is assembled.

use super::Lowering;
use super::name::Referent;
use super::rolling;
use crate::model::{JointId, JointKind, LinkId, Near, StartValue};
use crate::syntax::Place;
use crate::syntax::ast::{Name, Start, StartClause};

impl Lowering {
    pub(super) fn lower_start(&mut self, start: &Start) {
        self.single(start.keyword, "start", "put everything into the first");
        for clause in &start.clauses {
            self.report.next_item();
            match clause {
                Ok(clause) => self.start_clause(clause),
                Err(error) => self.report.pass_on(error.clone()),
            }
        }
    }

    fn start_clause(&mut self, clause: &StartClause) {
        let named = self.look_up(&clause.name);
        match (named, clause.near) {
            (Some(Referent::Link(body)), true) => self.near(clause, body.id),
            (Some(Referent::Joint(Some(id))), false) => self.start_value(clause, id),
            (named, _) => {
                self.value(&clause.value);
                self.misfit(clause, named);
            }
        }
    }

    /// Complains about a name of the wrong kind.
    fn misfit(&mut self, clause: &StartClause, named: Option<Referent>) {
        let name = &clause.name;
        if self.is_shared(name) {
            return;
        }
        let text = match named {
            Some(Referent::Link(_)) => {
                format!(
                    "`{name}` is a link; write `{name} near {}` to choose the assembly nearest to an angle",
                    clause.value
                )
            }
            Some(Referent::Joint(Some(joint))) if clause.near => self.near_a_joint(clause, joint),
            Some(Referent::Joint(_) | Referent::Broken) => return,
            Some(Referent::Use) => {
                self.find_body(name);
                return;
            }
            None if clause.near => {
                self.find_link(name);
                return;
            }
            None => {
                self.find_joint(name);
                return;
            }
        };
        self.report.error(name.place(), text);
    }

    /// What to write for `near` with a joint: its coordinate, if that can be given, or else the angle of a link.
    fn near_a_joint(&self, clause: &StartClause, joint: JointId) -> String {
        let (name, value) = (&clause.name, &clause.value);
        let beginning = format!("`{name}` is a joint, and `near` takes a link");
        if let Some(text) = self.no_coordinate(name, joint, "give") {
            return format!("{beginning}; {text}");
        }
        if self.model.motor_of(joint).is_some() {
            return format!("{beginning}; write `{name} = {value}`");
        }
        let (a, b) = self.model.ends(joint);
        let link = [b, a]
            .into_iter()
            .find(|&link| link != LinkId::GROUND && self.model.link(link).die.is_none());
        match (link, self.model.joint(joint).kind) {
            (Some(link), JointKind::Revolute(..)) => {
                let link = &self.model.link(link).name;
                format!(
                    "{beginning}; write `{link} near {value}`, with the angle of `{link}` in the scene"
                )
            }
            (Some(link), _) => {
                let link = &self.model.link(link).name;
                format!(
                    "{beginning}; choose the assembly by the angle of a link, such as `{link} near 0 deg`"
                )
            }
            (None, _) => beginning,
        }
    }

    fn near(&mut self, clause: &StartClause, link: LinkId) {
        let angle = self.value(&clause.value);
        let name = &clause.name;
        if link == LinkId::GROUND {
            self.report
                .error(name.place(), "`ground` is fixed; leave this out");
        } else if self.model.start.near.iter().any(|near| near.link == link) {
            let text =
                format!("there is a `near` for link `{name}` already; remove one of the two");
            self.report.error(name.place(), text);
        } else if let Some(angle) = angle
            && !self.is_degrees_perhaps(&clause.value, angle)
        {
            let origin = self.places.note(place(clause));
            let angle = self.similarity.sense() * angle + self.scopes.here().angle;
            self.model.start.near.push(Near {
                link,
                angle,
                origin,
            });
        }
    }

    fn start_value(&mut self, clause: &StartClause, joint: JointId) {
        let Some(value) = self.value(&clause.value) else {
            return;
        };
        if let Some((place, text)) = self.start_trouble(clause, joint, value) {
            self.report.error(place, text);
            return;
        }
        let turns = matches!(self.model.joint(joint).kind, JointKind::Revolute(..));
        if turns && self.is_degrees_perhaps(&clause.value, value) {
            return;
        }
        self.check_in_range(&clause.name, joint, (value, &clause.value));
        let value = self.own_coordinate(joint, value);
        let origin = self.places.note(place(clause));
        self.model.start.values.push(StartValue {
            joint,
            value,
            origin,
        });
    }

    /// Why a joint cannot start at this value, and what to point at.
    fn start_trouble(
        &self,
        clause: &StartClause,
        joint: JointId,
        value: f64,
    ) -> Option<(Place, String)> {
        let name = &clause.name;
        let place = name.place();
        if let Some(text) = self.no_coordinate(name, joint, "give") {
            return Some((place, text));
        }
        if self
            .model
            .start
            .values
            .iter()
            .any(|value| value.joint == joint)
        {
            return Some((
                place,
                format!("there is a start for joint `{name}` already; remove one of the two"),
            ));
        }
        (value != 0.0 && self.is_drawn(joint)).then(|| {
            let text = format!(
                "joint `{name}` is placed in the drawing, where its coordinate is 0; \
                 leave this out, or draw its links as they are to start"
            );
            (clause.value.place, text)
        })
    }

    /// What to say about a joint that has no coordinate that somebody could give or show.
    pub(super) fn no_coordinate(&self, name: &Name, joint: JointId, verb: &str) -> Option<String> {
        let kind = self.model.joint(joint).kind;
        let (word, remedy) = match (rolling::word_for(kind), kind) {
            (Some(word), JointKind::Rack { .. }) => (
                word,
                format!("{verb} that of the joint of its pinion or its bar"),
            ),
            (Some(word), JointKind::Cam { shaft, .. }) => (
                word,
                format!(
                    "{verb} that of its shaft, `{}`",
                    self.model.joint(shaft).name
                ),
            ),
            (Some(word), _) => (
                word,
                format!("{verb} that of the joint of one of its wheels"),
            ),
            (None, JointKind::Weld(..)) => ("weld", "leave this out".to_owned()),
            (None, _) => return None,
        };
        Some(format!(
            "`{name}` is a {word}, which has no coordinate; {remedy}"
        ))
    }

    /// Whether a joint was placed by `at`.
    pub(super) fn is_drawn(&self, joint: JointId) -> bool {
        match self.model.joint(joint).kind {
            JointKind::Revolute(axis, _) | JointKind::Prismatic(axis, _) => {
                self.model.axis(axis).name.is_none()
            }
            _ => false,
        }
    }
}

fn place(clause: &StartClause) -> Place {
    clause.name.place().to(clause.value.place)
}
