//! The start: assembled in no way, or in several.

use super::Words;
use super::wording::{brief, places_enough, rounded};
use crate::model::{JointId, LinkId, Origin, Start};
use crate::repair::Offers;
use crate::structure::Diagnosis;

impl Words<'_> {
    pub(super) fn assembly(&self, diagnosis: &Diagnosis, offers: &Offers) -> (Origin, String) {
        match diagnosis {
            Diagnosis::CannotClose {
                unknowns,
                gap,
                axes,
            } => (
                self.middle(unknowns),
                format!(
                    "the mechanism cannot close at its start: {} and {} stay {} apart\nnote: {} freely, and this is \
                     as near as they bring them\nhelp: change a length, or start the motors elsewhere",
                    self.axis(axes.0),
                    self.axis(axes.1),
                    brief(*gap),
                    self.the_joints(unknowns, ["turns or slides", "turn or slide"])
                ),
            ),
            Diagnosis::DeadStart { unknowns } => (
                self.middle(unknowns),
                format!(
                    "the mechanism starts at a dead point: which way {} from there is not determined{}",
                    self.the_joints(unknowns, ["goes", "go"]),
                    self.start_elsewhere(offers)
                ),
            ),
            Diagnosis::SeveralAssemblies { links, angles } => {
                let origin = links
                    .first()
                    .map_or(self.model.origin, |link| self.model.link(*link).origin);
                (origin, self.several(links, angles))
            }
            Diagnosis::NotAsDrawn { link } => self.not_as_drawn(*link),
            Diagnosis::StartNotFree { joint } => self.start_not_free(*joint),
            _ => (self.model.origin, String::new()),
        }
    }

    /// Where a loop is told of: at its middle joint.
    fn middle(&self, unknowns: &[JointId]) -> Origin {
        let joint = unknowns.get(1).or(unknowns.first());
        joint.map_or(self.model.origin, |&joint| self.model.joint(joint).origin)
    }

    fn start_elsewhere(&self, offers: &Offers) -> String {
        let help = self.help(offers);
        if help.is_empty() {
            "\nhelp: start the motors elsewhere".to_owned()
        } else {
            help
        }
    }

    fn several(&self, links: &[LinkId], angles: &[Vec<f64>]) -> String {
        let places = places_enough(links.len(), angles);
        let (before, after) = if self.model.start == Start::default() {
            ("`start { ", " }`")
        } else {
            ("`", "` to `start`")
        };
        let clause = |angles: &Vec<f64>| {
            let parts = links.iter().zip(angles).map(|(link, angle)| {
                let angle = rounded(angle.to_degrees(), places);
                format!("{} near {angle} deg;", self.model.link(*link).name)
            });
            let parts = parts.collect::<Vec<_>>().join(" ");
            format!("\nhelp: add {before}{parts}{after}")
        };
        let shown: String = angles.iter().take(8).map(clause).collect();
        let more = if angles.len() > 8 {
            "\nnote: there are more"
        } else {
            ""
        };
        let count = if angles.len() > 64 {
            "more than 64".to_owned()
        } else {
            angles.len().to_string()
        };
        format!(
            "the mechanism can be assembled in {count} ways; `near` says which one is meant{shown}{more}"
        )
    }
}
