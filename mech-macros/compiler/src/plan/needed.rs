//! Which steps the poses of some links depend on.

use super::cluster::Clusters;
use super::step::{Connection, Source, Step};
use super::{Plan, Rational};
use crate::model::{AxisId, JointKind, LinkId, Model};

/// The part of a plan that some poses depend on.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanPart {
    /// For each step whether it is needed.
    pub steps: Vec<bool>,
    /// For each source of gears, belts and racks whether it is needed.
    pub sources: Vec<bool>,
}

impl Plan {
    /// All of it.
    #[must_use]
    pub fn whole(&self) -> PlanPart {
        PlanPart { steps: vec![true; self.steps.len()], sources: vec![true; self.sources.len()] }
    }

    /// The steps that the poses of these links depend on. The plan is read backwards: a step is needed if it places a link that is
    /// needed. Links that no step places keep their poses in their clusters, bit by bit.
    #[must_use]
    pub fn find_needed(&self, model: &Model, links: &[LinkId]) -> PlanPart {
        let mut needed = PlanPart {
            steps: vec![false; self.steps.len()],
            sources: vec![false; self.sources.len()],
        };
        let mut wanted = vec![false; model.links.len()];
        for link in links {
            wanted[link.index()] = true;
        }
        let ends = self.steps.iter().map(|step| ends(model, step));
        let ends: Vec<Vec<LinkId>> = ends.collect();
        let clusters = clusters_before(model, &ends);
        let first_reader = self.first_readers();
        for (index, step) in self.steps.iter().enumerate().rev() {
            let base = |link: LinkId| clusters[index].base(link);
            let stays = ends[index].iter().map(|&link| base(link)).min();
            let moved = |link: &LinkId| {
                let own = base(*link);
                Some(own) != stays && ends[index].iter().any(|&end| base(end) == own)
            };
            if model.link_ids().any(|link| wanted[link.index()] && moved(&link)) {
                needed.steps[index] = true;
                for end in &ends[index] {
                    wanted[end.index()] = true;
                }
                for (source, _) in step.sources() {
                    needed.sources[*source] = true;
                }
            }
            // A source is read once, where the first step needs it that comes to it.
            for (number, source) in self.sources.iter().enumerate() {
                if needed.sources[number] && first_reader[number] == Some(index) {
                    for link in read_by(model, source) {
                        wanted[link.index()] = true;
                    }
                }
            }
        }
        needed
    }

    /// For each source the first step that reads it.
    fn first_readers(&self) -> Vec<Option<usize>> {
        let first = |number: usize| {
            self.steps.iter().position(|step| step.sources().any(|(source, _)| *source == number))
        };
        (0..self.sources.len()).map(first).collect()
    }
}

impl Step {
    /// The joints it closes.
    pub(crate) fn connections(&self) -> Vec<Connection> {
        match self {
            Self::Weld(weld) => vec![weld.connection],
            Self::Drive(drive) => vec![drive.connection],
            Self::Mesh(mesh) => vec![mesh.connection],
            Self::Cam(cam) => vec![cam.connection],
            Self::Close(closing) => {
                let rings = closing.rings.iter().flatten();
                rings.chain(&closing.tree).copied().collect()
            }
        }
    }

    /// The parts of sources that it reads.
    pub(crate) fn sources(&self) -> impl Iterator<Item = &(usize, Rational)> {
        let (mesh, ties) = match self {
            Self::Mesh(mesh) => (&mesh.parts[..], &[][..]),
            Self::Cam(cam) => (&cam.parts[..], &[][..]),
            Self::Close(closing) => (&[][..], &closing.ties[..]),
            Self::Weld(_) | Self::Drive(_) => (&[][..], &[][..]),
        };
        mesh.iter().chain(ties.iter().flat_map(|tie| &tie.sources))
    }
}

/// The links whose axes a step brings together.
fn ends(model: &Model, step: &Step) -> Vec<LinkId> {
    let link = |axis: AxisId| model.axis(axis).link;
    let connections = step.connections().into_iter();
    let ends = connections.flat_map(|connection| [link(connection.from), link(connection.to)]);
    ends.collect()
}

/// For each step the clusters as they are before it.
fn clusters_before(model: &Model, ends: &[Vec<LinkId>]) -> Vec<Clusters> {
    let mut clusters = Clusters::new(model.links.len());
    let before = ends.iter().map(|ends| {
        let before = clusters.clone();
        let bases: Vec<LinkId> = ends.iter().map(|&link| clusters.base(link)).collect();
        clusters.merge(&bases);
        before
    });
    before.collect()
}

/// The links whose poses the value of a source depends on.
fn read_by(model: &Model, source: &Source) -> Vec<LinkId> {
    match *source {
        Source::Motor(_) => Vec::new(),
        Source::Angle { from, to } => vec![from, to],
        Source::Displacement(joint) => match model.joint(joint).kind {
            JointKind::Prismatic(from, to) => vec![model.axis(from).link, model.axis(to).link],
            _ => Vec::new(),
        },
    }
}
