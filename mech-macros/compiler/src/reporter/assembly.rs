//! The start: no assembly, or several.

use super::Words;
use super::wording::{brief, places_enough};
use crate::bug::bug;
use crate::digits::round_to;
use crate::model::{JointId, LinkId, Origin, Start};
use crate::repair::Offers;
use crate::structure::{Diagnosis, LoopAssembly, OpenLoop};

/// More assemblies than these are not listed, but loop by loop.
const LISTED: usize = 4;

impl Words<'_> {
    pub(super) fn assembly(&self, diagnosis: &Diagnosis, offers: &Offers) -> (Origin, String) {
        match diagnosis {
            Diagnosis::CannotClose { unknowns, gap, axes } => (
                self.middle(unknowns),
                format!(
                    "the mechanism cannot close at its start: {} and {} stay {} apart\nnote: {} freely, but bring \
                     them no nearer{}",
                    self.axis(axes.0),
                    self.axis(axes.1),
                    brief(*gap),
                    self.the_joints(unknowns, ["turns or slides", "turn or slide"]),
                    match self.help(offers) {
                        none if none.is_empty() =>
                            "\nhelp: change a length, or start the motors elsewhere".to_owned(),
                        help => help + "\nhelp: or start the motors elsewhere",
                    }
                ),
            ),
            Diagnosis::DeadStart { unknowns } => (
                self.middle(unknowns),
                format!(
                    "the mechanism starts at a dead point: from there {} go either way{}",
                    self.the_joints(unknowns, ["can", "can"]),
                    self.start_elsewhere(offers)
                ),
            ),
            Diagnosis::SeveralAssemblies { links, angles, loops, many } => {
                let origin = self.at_link(links.first());
                let help = if is_long(*many, angles) {
                    self.one_by_one(loops)
                } else {
                    self.all_assemblies(links, angles, loops)
                };
                let count =
                    if *many { "more than 64".to_owned() } else { angles.len().to_string() };
                let text = format!(
                    "the mechanism can be assembled in {count} ways; `near` says which one is meant{help}"
                );
                (origin, text)
            }
            Diagnosis::NotAsDrawn { link } => self.not_as_drawn(*link),
            Diagnosis::StartNotFree { joint } => self.start_not_free(*joint),
            other => bug!("nothing is said of {other:?}"),
        }
    }

    /// Where a message about a loop stands: at its middle joint.
    fn middle(&self, unknowns: &[JointId]) -> Origin {
        let joint = unknowns.get(1).or(unknowns.first());
        joint.map_or(self.model.origin, |&joint| self.model.joint(joint).origin)
    }

    pub(super) fn start_elsewhere(&self, offers: &Offers) -> String {
        let help = self.help(offers);
        if help.is_empty() { "\nhelp: start the motors elsewhere".to_owned() } else { help }
    }

    /// For each possible assembly the clauses of a start that choose it. Of very many assemblies, only the clauses of the first.
    pub(super) fn assemblies(&self, diagnosis: &Diagnosis) -> Vec<String> {
        match diagnosis {
            Diagnosis::SeveralAssemblies { links, angles, loops, many } => {
                if is_long(*many, angles) {
                    vec![self.first_assembly(loops)]
                } else {
                    self.all_clauses(links, angles)
                }
            }
            _ => Vec::new(),
        }
    }

    /// For each assembly the directions of links that it has.
    fn all_clauses(&self, links: &[LinkId], angles: &[Vec<f64>]) -> Vec<String> {
        let places = places_enough(links.len(), angles);
        let clauses = angles.iter().map(|angles| {
            let parts = links.iter().zip(angles).map(|(link, angle)| {
                let angle = round_to(angle.to_degrees(), places);
                format!("{} near {angle} deg;", self.model.link(*link).name)
            });
            parts.collect::<Vec<_>>().join(" ")
        });
        clauses.collect()
    }

    /// A statement for each assembly. That of a single loop says where its joint is then.
    fn all_assemblies(&self, links: &[LinkId], angles: &[Vec<f64>], loops: &[OpenLoop]) -> String {
        let clauses = self.all_clauses(links, angles).into_iter().enumerate();
        let lines = clauses.map(|(number, clauses)| {
            let then = match loops {
                [OpenLoop { joint, assemblies, .. }] => assemblies.get(number).map(|assembly| {
                    let at = self.format_coordinate(*joint, assembly.coordinate);
                    format!(": {} is then at {at}", self.joint(*joint))
                }),
                _ => None,
            };
            format!("\nhelp: add {}{}", self.in_start(&clauses), then.unwrap_or_default())
        });
        lines.collect()
    }

    /// For each loop a direction that it has in the first assembly.
    fn first_assembly(&self, loops: &[OpenLoop]) -> String {
        let clauses = loops.iter().filter_map(|open| {
            let assembly = open.assemblies.first()?;
            Some(self.clause(open, assembly))
        });
        clauses.collect::<Vec<_>>().join(" ")
    }

    /// The direction by which an assembly of a loop is chosen.
    fn clause(&self, open: &OpenLoop, assembly: &LoopAssembly) -> String {
        let angles: Vec<Vec<f64>> =
            open.assemblies.iter().map(|assembly| vec![assembly.angle]).collect();
        let angle = round_to(assembly.angle.to_degrees(), places_enough(1, &angles));
        format!("{} near {angle} deg;", self.model.link(open.link).name)
    }

    /// A statement for the first assembly, and for each loop what would close it otherwise.
    fn one_by_one(&self, loops: &[OpenLoop]) -> String {
        let others = loops.iter().map(|open| {
            let Some((first, others)) = open.assemblies.split_first() else {
                return String::new();
            };
            let joint = self.joint(open.joint);
            let first = self.format_coordinate(open.joint, first.coordinate);
            let others = others.iter().map(|assembly| {
                let there = self.format_coordinate(open.joint, assembly.coordinate);
                format!("`{}` puts it at {there}", self.clause(open, assembly))
            });
            let others: Vec<String> = others.collect();
            format!("\nhelp: {joint} is then at {first}; instead {}", others.join(", "))
        });
        let others: String = others.collect();
        format!("\nhelp: add {}{others}", self.in_start(&self.first_assembly(loops)))
    }

    /// Clauses, and where they go.
    pub(super) fn in_start(&self, clauses: &str) -> String {
        if self.model.start == Start::default() {
            format!("`start {{ {clauses} }}`")
        } else {
            format!("`{clauses}` to `start`")
        }
    }
}

/// Whether there are too many assemblies to list them.
fn is_long(many: bool, angles: &[Vec<f64>]) -> bool {
    many || angles.len() > LISTED
}
