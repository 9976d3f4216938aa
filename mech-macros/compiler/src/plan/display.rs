//! A plan as text, for whoever works on the compiler: a line for each step, in the user's names.

use super::Plan;
use super::cluster::Clusters;
use super::linear_relations::{Rational, fraction};
use super::step::{Connection, ConnectionKind, Loop, Source, Step, Tie};
use super::triad::Triad;
use super::unknown::Unknown;
use crate::model::{AxisId, JointId, LinkId, Model};
use std::fmt::{self, Display, Formatter};

/// A plan with the model that has its names: it is printed as one line for each step.
#[derive(Clone, Copy, Debug)]
pub struct PlanText<'a> {
    plan: &'a Plan,
    model: &'a Model,
}

impl Plan {
    /// This plan as text, in the names of the model that it was made for.
    #[must_use]
    pub fn display<'a>(&'a self, model: &'a Model) -> PlanText<'a> {
        PlanText { plan: self, model }
    }
}

impl Display for PlanText<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "plan of {}", self.model.name)?;
        let mut clusters = Clusters::new(self.model.links.len());
        let mut loops = 0;
        for (number, step) in self.plan.steps.iter().enumerate() {
            if let Step::Close(_) = step {
                loops += 1;
            }
            let what = self.step(step, loops, &clusters);
            let placed = self.placement_text(step, &mut clusters);
            writeln!(f, "{}. {what}; {placed}", number + 1)?;
        }
        Ok(())
    }
}

impl PlanText<'_> {
    /// The line of a step; `loops` counts the loops up to it.
    fn step(&self, step: &Step, loops: usize, clusters: &Clusters) -> String {
        match step {
            Step::Weld(weld) => format!("weld {}", self.joint(weld.connection.joint)),
            Step::Drive(drive) => format!(
                "motor {}: gives the {}",
                self.joint(drive.connection.joint),
                coordinate(drive.connection.kind)
            ),
            Step::Mesh(mesh) => format!(
                "rolls {}: moves {} by {}",
                self.joint(mesh.by),
                self.joint(mesh.connection.joint),
                self.parts(&mesh.parts).join(" + ")
            ),
            Step::Cam(cam) => format!(
                "cam {}: gives {}, its shaft moves by {}",
                self.joint(cam.by),
                self.joint(cam.connection.joint),
                self.parts(&cam.parts).join(" + ")
            ),
            Step::Close(closing) => self.loop_text(closing, loops, clusters),
        }
    }

    fn loop_text(&self, closing: &Loop, number: usize, clusters: &Clusters) -> String {
        let unknowns: Vec<String> = closing
            .connections()
            .map(|unknown| format!("{} ({})", self.joint(unknown.joint), coordinate(unknown.kind)))
            .collect();
        let kind = self.kind(closing, clusters);
        let mut text = format!("loop {number}: {kind}, unknown {}", unknowns.join(", "));
        for tie in &closing.ties {
            text += &format!(", {}", self.tie(tie));
        }
        text
    }

    /// The kind of a loop: a dyad by the letters of its joints, or why it is none.
    fn kind(&self, closing: &Loop, clusters: &Clusters) -> String {
        let letters = |ring: &Vec<Connection>| -> String {
            ring.iter()
                .map(|connection| match connection.kind {
                    ConnectionKind::Revolute => 'R',
                    ConnectionKind::Prismatic => 'P',
                })
                .collect()
        };
        let tied = if closing.ties.is_empty() { "" } else { "tied, " };
        match &closing.rings[..] {
            rings if rings.len() > 1 => {
                let triad = Triad::of(closing, |axis| clusters.base(self.link_of(axis)));
                let kind = triad.map_or("coupled", |_| "triad");
                let rings: Vec<String> = rings.iter().map(letters).collect();
                format!("{tied}{kind}, rings {}", rings.join(" and "))
            }
            [ring] if closing.is_redundant() => format!("{tied}redundant {}", letters(ring)),
            [ring] if closing.ties.is_empty() && ring.len() <= 3 => {
                format!("dyad {}", letters(ring))
            }
            rings => format!("{tied}ring {}", rings.iter().map(letters).collect::<String>()),
        }
    }

    /// The links that a step places, and relative to what: it merges their clusters.
    fn placement_text(&self, step: &Step, clusters: &mut Clusters) -> String {
        let mut bases: Vec<LinkId> = step
            .connections()
            .iter()
            .flat_map(|connection| [connection.from, connection.to])
            .map(|axis| clusters.base(self.link_of(axis)))
            .collect();
        bases.sort_unstable();
        bases.dedup();
        let links: Vec<String> = bases
            .iter()
            .skip(1)
            .flat_map(|&base| clusters.links(base))
            .map(|link| self.link(link))
            .collect();
        let whole = clusters.merge(&bases);
        format!("places {} on {}", links.join(", "), self.link(whole))
    }

    fn tie(&self, tie: &Tie) -> String {
        let unknowns = tie.parts.iter();
        let mut parts: Vec<String> = unknowns
            .map(|(of, part)| format!("{} * {}", fraction(part), self.unknown(*of)))
            .collect();
        parts.extend(self.parts(&tie.sources));
        format!("{} tied to {}", self.unknown(tie.of), parts.join(" + "))
    }

    fn parts(&self, parts: &[(usize, Rational)]) -> Vec<String> {
        parts
            .iter()
            .map(|(source, part)| format!("{} * {}", fraction(part), self.source(*source)))
            .collect()
    }

    fn source(&self, number: usize) -> String {
        match self.plan.sources[number] {
            Source::Motor(motor) => self.joint(self.model.motor(motor).joint).to_owned(),
            Source::Angle { from, to } => {
                format!("angle from {} to {}", self.link(from), self.link(to))
            }
            Source::Displacement(joint) => self.joint(joint).to_owned(),
        }
    }

    fn unknown(&self, unknown: Unknown) -> String {
        match unknown {
            Unknown::Direction(link) => format!("direction of {}", self.link(link)),
            Unknown::Slide(joint) => format!("length of {}", self.joint(joint)),
        }
    }

    fn link_of(&self, axis: AxisId) -> LinkId {
        self.model.axis(axis).link
    }

    /// The name of a link; the hidden one of a pin in a slot has that of the slot.
    fn link(&self, link: LinkId) -> String {
        let link = self.model.link(link);
        match link.die {
            Some(_) => format!("the die of {}", link.name),
            None => link.name.clone(),
        }
    }

    fn joint(&self, joint: JointId) -> &str {
        &self.model.joint(joint).name
    }
}

fn coordinate(kind: ConnectionKind) -> &'static str {
    match kind {
        ConnectionKind::Revolute => "angle",
        ConnectionKind::Prismatic => "length",
    }
}
