//! Puts diagnoses, and what would mend them, into words and at their places.

mod assembly;
mod cam;
mod carrier;
mod declaration;
mod drawing;
mod effort;
mod exactness;
mod held;
mod inverse;
mod names;
mod order;
mod range;
mod repairs;
mod requirement;
mod start;
mod wording;

use crate::model::{JointId, LinkId, Model, MotorId, Origin};
use crate::repair::{Offers, Repair};
use crate::structure::Diagnosis;
use crate::syntax::{Message, Places};
use std::collections::{BTreeMap, HashMap};
use std::mem::{Discriminant, discriminant};

/// Everything that is wrong, as the user reads it. Lines after the first of each message begin with `note:` or `help:`.
/// There is an offer for each diagnosis. Of very many only the first are told.
#[must_use]
pub fn messages(
    diagnoses: &[Diagnosis],
    offers: &[Offers],
    model: &Model,
    places: &Places,
) -> Vec<Message> {
    let words = Words { model };
    let none = Offers::default();
    let mut messages = Vec::new();
    let mut reported = reported(diagnoses, model).into_iter();
    while messages.len() <= Message::MOST
        && let Some(Reported { number, more }) = reported.next()
    {
        let offers = offers.get(number).unwrap_or(&none);
        for (origin, mut text) in words.of(&diagnoses[number], offers) {
            if let Some((part, count)) = more {
                let instances = if count == 1 { "instance" } else { "instances" };
                text += &format!(
                    "\nnote: the same is wrong in {count} more {instances} of part `{part}`"
                );
            }
            messages.push(Message::new(places.get(origin), space_notes(&text)));
        }
    }
    Message::first(messages, reported.len())
}

/// A diagnosis in words, without its place and without what would mend it.
#[must_use]
pub fn text(diagnosis: &Diagnosis, model: &Model) -> String {
    let messages = Words { model }.of(diagnosis, &Offers::default());
    let texts: Vec<String> = messages.iter().map(|(_, text)| space_notes(text)).collect();
    texts.join("\n\n")
}

/// Changes that are made together, in words: `remove link brace and link strut`.
#[must_use]
pub fn repair_text(repairs: &[Repair], model: &Model) -> String {
    Words { model }.all_together(repairs)
}

/// For each assembly among which a start has to choose, the clauses of `start` that choose it, and what is to be done in words; none for
/// other diagnoses. Of very many only the first is given.
#[must_use]
pub fn assemblies(diagnosis: &Diagnosis, model: &Model) -> Vec<[String; 2]> {
    let words = Words { model };
    let clauses = words.assemblies(diagnosis).into_iter();
    clauses
        .map(|clauses| {
            let text = format!("add {}", words.in_start(&clauses));
            [clauses, text]
        })
        .collect()
}

/// Sets the notes off from the sentence.
fn space_notes(text: &str) -> String {
    text.replacen('\n', "\n\n", 1)
}

struct Words<'m> {
    model: &'m Model,
}

impl Words<'_> {
    fn of(&self, diagnosis: &Diagnosis, offers: &Offers) -> Vec<(Origin, String)> {
        let messages = match diagnosis {
            Diagnosis::Loose { link } => (self.at_link(Some(link)), self.loose(*link, offers)),
            Diagnosis::Disconnected { links } => {
                (self.at_link(links.first()), self.disconnected(links, offers))
            }
            Diagnosis::NotCarrier { joint, link } => {
                (self.at_joint(Some(joint)), self.not_carrier(*joint, *link, offers))
            }
            Diagnosis::NoCarrier { joint } => {
                (self.at_joint(Some(joint)), self.no_carrier(*joint, offers))
            }
            Diagnosis::SeveralCarriers { joint, carriers } => {
                (self.at_joint(Some(joint)), self.several_carriers(*joint, carriers))
            }
            Diagnosis::NoMesh { joint, carrier, ratio, trouble } => (
                self.at_joint(Some(joint)),
                self.no_mesh(*joint, *carrier, *ratio, *trouble) + &self.help_or_pairs(offers),
            ),
            Diagnosis::Blocked { motor, part, joints } => {
                (self.model.motor(*motor).origin, self.blocked(*motor, part, joints, offers))
            }
            Diagnosis::TooManyMotors { motor, among } => {
                (self.model.motor(*motor).origin, self.too_many(*motor, among, offers))
            }
            Diagnosis::Rigid => (self.model.origin, self.rigid(offers)),
            Diagnosis::Overdetermined { joints, is_mobile } => {
                (self.at_joint(joints.first()), self.overdetermined(joints, *is_mobile, offers))
            }
            Diagnosis::Massless { motors } => return self.massless(motors),
            Diagnosis::OverconstrainedWithParam { joints, param } => {
                (self.at_joint(joints.first()), self.matched_only(joints, *param))
            }
            Diagnosis::Overflow { culprit } => self.overflow(*culprit),
            Diagnosis::Unmet { requirement, trouble } => self.unmet(*requirement, trouble, offers),
            Diagnosis::Inverse { trouble } => self.cannot_follow(trouble, offers),
            Diagnosis::TooLarge => (self.model.origin, self.too_large()),
            Diagnosis::TooSmall => (self.model.origin, self.too_small()),
            Diagnosis::EndlessAccuracy { accuracy, motor } => {
                (self.model.motor(*motor).origin, self.endless_accuracy(*accuracy, *motor))
            }
            Diagnosis::TooAccurate { accuracy, best } => {
                (self.model.origin, self.too_accurate(*accuracy, *best))
            }
            Diagnosis::NoMotor { freedom, candidates } => {
                (self.model.origin, self.no_motor(*freedom, candidates, offers))
            }
            Diagnosis::Undetermined { freedom, free, .. } => {
                (self.at_joint(free.first()), self.undetermined(*freedom, free, offers))
            }
            Diagnosis::OnOnePin { link, joints } => {
                (self.at_joint(joints.last()), self.on_one_pin(*link, joints, offers))
            }
            Diagnosis::NotSequential { waiting, rings } => {
                return self.cycle(waiting, rings, offers);
            }
            Diagnosis::Range { motor, unknowns, trouble } => self.range(*motor, unknowns, trouble),
            Diagnosis::CamNotDriven { joint } => {
                (self.at_joint(Some(joint)), self.cam_not_driven(*joint))
            }
            Diagnosis::CamWithoutValue { joint, at } => self.cam_without_value(*joint, *at),
            Diagnosis::CannotClose { .. }
            | Diagnosis::DeadStart { .. }
            | Diagnosis::SeveralAssemblies { .. }
            | Diagnosis::NotAsDrawn { .. }
            | Diagnosis::StartNotFree { .. } => self.assembly(diagnosis, offers),
        };
        vec![messages]
    }

    fn at_joint(&self, joint: Option<&JointId>) -> Origin {
        joint.map_or(self.model.origin, |&joint| self.model.joint(joint).origin)
    }

    fn at_link(&self, link: Option<&LinkId>) -> Origin {
        link.map_or(self.model.origin, |&link| self.model.link(link).origin)
    }

    fn loose(&self, link: LinkId, offers: &Offers) -> String {
        let joins = |repair: &Repair| matches!(repair, Repair::Declare(_));
        let joined = offers.single.iter().any(joins) || !offers.pairs.is_empty();
        let help = self.help(offers);
        let help = if joined {
            self.help_or_pairs(offers)
        } else if help.is_empty() {
            let joint = self.some_joint(link);
            format!("\nhelp: declare a joint, as `joint NAME = {joint};`, or remove the link")
        } else {
            let joint = self.some_joint(link);
            format!("{help}, or declare a joint, as `joint NAME = {joint};`")
        };
        format!("nothing holds link {}: no joint joins it to anything{help}", self.link(link))
    }

    fn disconnected(&self, links: &[LinkId], offers: &Offers) -> String {
        let links = self.moving_links(links);
        let help = if offers.is_empty() {
            "\nhelp: declare a joint between one of them and the ground or a link that is connected to it".to_owned()
        } else {
            self.help_or_pairs(offers)
        };
        format!(
            "{} {} not connected to the ground{help}",
            self.links(&links),
            if links.len() == 1 { "is" } else { "are" },
        )
    }

    fn massless(&self, motors: &[MotorId]) -> Vec<(Origin, String)> {
        let messages = motors.iter().map(|&motor| {
            let motor = self.model.motor(motor);
            let text = format!(
                "nothing that motor {} moves has a mass, so forces cannot determine how it moves\nhelp: give a link that it moves \
                 a `mass` or a `density`, or leave the effect `dynamics` out",
                self.joint(motor.joint)
            );
            (motor.origin, text)
        });
        messages.collect()
    }
}

/// A diagnosis that stands for itself and for those of other instances.
struct Reported<'d> {
    /// The number of the diagnosis.
    number: usize,
    /// The part, and in how many more of its instances the same is wrong; none if in no other.
    more: Option<(&'d str, usize)>,
}

/// The diagnoses that are reported: of each joint or link of a part the first.
fn reported<'d>(diagnoses: &[Diagnosis], model: &'d Model) -> Vec<Reported<'d>> {
    let parts = model.instances.iter();
    let parts: BTreeMap<&str, &str> =
        parts.map(|instance| (instance.path.as_str(), instance.part.as_str())).collect();
    let mut reported: Vec<Reported<'d>> = Vec::new();
    let mut first: HashMap<(Discriminant<Diagnosis>, &str, &str), usize> = HashMap::new();
    for (number, diagnosis) in diagnoses.iter().enumerate() {
        let declared = subject(diagnosis, model).and_then(|name| declaration(name, &parts));
        if let Some((part, local)) = declared {
            let key = (discriminant(diagnosis), part, local);
            let known = *first.entry(key).or_insert(reported.len());
            if let Some(reported) = reported.get_mut(known) {
                let (_, count) = reported.more.get_or_insert((part, 0));
                *count += 1;
                continue;
            }
        }
        reported.push(Reported { number, more: None });
    }
    reported
}

/// The name of the one joint or link that a diagnosis is about.
fn subject<'m>(diagnosis: &Diagnosis, model: &'m Model) -> Option<&'m str> {
    match diagnosis {
        Diagnosis::Loose { link } | Diagnosis::OnOnePin { link, .. } => {
            Some(&model.link(*link).name)
        }
        Diagnosis::NotCarrier { joint, .. }
        | Diagnosis::NoCarrier { joint }
        | Diagnosis::SeveralCarriers { joint, .. }
        | Diagnosis::NoMesh { joint, .. } => Some(&model.joint(*joint).name),
        _ => None,
    }
}

/// The part in which something was declared, and its name there.
fn declaration<'m>(name: &'m str, parts: &BTreeMap<&str, &'m str>) -> Option<(&'m str, &'m str)> {
    let (path, local) = name.rsplit_once('.')?;
    Some((*parts.get(path)?, local))
}
