//! The part of the search for gears, belts and racks: joints they move, and directions they tie.

use super::Knowledge;
use super::Search;
use super::open::named_on;
use crate::bug::bug;
use crate::model::{JointId, JointKind, LinkId};
use crate::plan::between::Sliding;
use crate::plan::linear_relations::{LinearForm, Rational};
use crate::plan::step::{Connection, ConnectionKind, Mesh, Source, Step, Tie};
use crate::plan::unknown::Unknown;
use crate::structure::{Factor, Rolling, RollingEnd};
use num_rational::BigRational;

impl Search<'_> {
    pub(super) fn rolls(&self) -> bool {
        !self.structure.rollings.is_empty()
    }

    /// Enters the relations of slides and welds, which keep links parallel, and those of rolling.
    pub(super) fn open_ledger(&mut self) {
        if !self.keeps_ledger {
            return;
        }
        for joint in self.model.joint_ids() {
            if let JointKind::Prismatic(..) | JointKind::Weld(..) = self.model.joint(joint).kind {
                let (a, b) = self.model.ends(joint);
                if !self.is_turned(joint) {
                    self.relations.add(&LinearForm::turn(a, b));
                }
                self.aligned.union(a.index(), b.index());
            }
        }
        for rolling in &self.structure.rollings {
            self.relations.add(&relation(rolling));
        }
        self.add_rings_of_slides();
    }

    /// Notes that displacements in one direction add up to zero round each ring of slides. Welded links count as one.
    fn add_rings_of_slides(&mut self) {
        let is_weld = |joint| matches!(self.model.joint(joint).kind, JointKind::Weld(..));
        let body = |link: LinkId| self.structure.welded.body(link);
        let heading = |joint| self.structure.parallels.of(joint);
        let mut sliding = Sliding::default();
        let mut sums = Vec::new();
        for joint in self.model.joint_ids() {
            let Some(own) = heading(joint) else {
                continue;
            };
            let (from, to) = self.model.ends(joint);
            if sliding.join(own.number, body(from), body(to)) {
                continue;
            }
            let is_before = |other| {
                let same = heading(other).is_some_and(|other| other.number == own.number);
                ((other < joint && same) || is_weld(other)).then_some(0)
            };
            let mut sum = LinearForm::slide(joint);
            let mut at = from;
            for step in self.graph.path(from, to, is_before) {
                let (a, b) = self.model.ends(step);
                let forwards = at == a;
                if let Some(other) = heading(step) {
                    let adds = forwards == (other.forwards == own.forwards);
                    let part = if adds { -one() } else { one() };
                    sum = sum.plus(&part, &LinearForm::slide(step));
                }
                at = if forwards { b } else { a };
            }
            sums.push(sum);
        }
        for sum in sums {
            self.relations.add(&sum);
        }
    }

    /// Notes a known quantity as a source, unless it follows from others.
    pub(super) fn source(&mut self, source: Source, quantity: &LinearForm, behind: Knowledge) {
        if self.keeps_ledger && self.relations.value(quantity).is_none() {
            let number = LinearForm::source(self.sources.len());
            self.relations.add(&quantity.clone().plus(&-one(), &number));
            self.sources.push(source);
            self.behind.push(behind);
        }
    }

    /// Whether params turn the links of a slide against each other. Without params a slide keeps their directions.
    fn is_turned(&self, joint: JointId) -> bool {
        let axes = self.model.joint(joint).kind.axes();
        axes.is_some_and(|axes| {
            let [a, b] = axes.map(|axis| self.model.axis(axis).direction_formulas);
            a != b
        })
    }

    /// Notes the angle across a slide that was just found as a source, if params turn it: no relation gives it.
    pub(super) fn turned_slide(&mut self, joint: JointId, how: &Knowledge) {
        if self.is_turned(joint) {
            let (from, to) = self.model.ends(joint);
            let angle = Source::Angle { from, to };
            self.source(angle, &LinearForm::turn(from, to), how.clone());
        }
    }

    /// Finds one joint that gears, belts or racks move: that of a wheel or bar on its carrier. First where the other part is
    /// known on the carrier; only then where several that roll determine each other, as in planetary gears: so that the outcome
    /// does not depend on the order of declaration.
    pub(super) fn mesh(&mut self) -> bool {
        if !self.rolls() {
            return false;
        }
        let ends =
            || self.structure.rollings.iter().flat_map(|rolling| [(rolling, 0), (rolling, 1)]);
        let direct = |(rolling, end): &(&Rolling, usize)| {
            let other = rolling.ends[1 - *end].0.link();
            self.clusters.are_joined(rolling.carrier, other)
        };
        // Where several joints could be said to be moved, the name decides, which no reordering changes.
        let name = |mesh: &Mesh| self.model.joint(mesh.connection.joint).name.clone();
        let moved = |(rolling, end)| self.mesh_of(rolling, end);
        let found = ends().filter(direct).filter_map(moved).min_by_key(name);
        let found = found.or_else(|| ends().filter_map(moved).min_by_key(name));
        let Some(mesh) = found else { return false };
        let how = Knowledge::of(mesh.parts.iter().map(|(source, _)| &self.behind[*source]));
        let (from, to) = self.link_of(mesh.connection);
        self.turned_slide(mesh.connection.joint, &how);
        self.merge(&[from, to], &how);
        self.steps.push(Step::Mesh(mesh));
        true
    }

    /// The step that places a wheel or bar on its carrier, if rolling gives its coordinate by now and no step has placed it yet.
    pub(super) fn mesh_of(&self, rolling: &Rolling, end: usize) -> Option<Mesh> {
        let connection = self.carrier_connection(rolling, rolling.ends[end].0)?;
        let (from, to) = self.link_of(connection);
        let (free, quantity) = match connection.kind {
            ConnectionKind::Revolute => {
                (!self.aligned.equiv(from.index(), to.index()), LinearForm::turn(from, to))
            }
            ConnectionKind::Prismatic => (true, self.along(connection)),
        };
        if !free || self.clusters.are_joined(from, to) {
            return None;
        }
        let parts = self.relations.value(&quantity)?;
        Some(Mesh { by: rolling.joint, connection, parts })
    }

    /// The joint by which a wheel or bar is on its carrier. A wheel may only share an axis with its carrier: then the declared joint that
    /// joins their clusters on that axis.
    pub(super) fn carrier_connection(
        &self,
        rolling: &Rolling,
        end: RollingEnd,
    ) -> Option<Connection> {
        let joint = match end {
            RollingEnd::Bar { slide, .. } => slide,
            RollingEnd::Wheel(wheel) => {
                let pin = self.structure.shaft(wheel, rolling.carrier)?;
                named_on(self.model, &self.clusters, pin, rolling.carrier, wheel)
            }
        };
        self.declared_connection(joint)
    }

    /// The displacement along a sliding connection, from its first axis to its second.
    pub(super) fn along(&self, connection: Connection) -> LinearForm {
        let slide = LinearForm::slide(connection.joint);
        let declared = self.model.ends(connection.joint) == self.link_of(connection);
        if declared { slide } else { LinearForm::default().plus(&-one(), &slide) }
    }

    /// The clusters of each gear, belt or rack that still ties them.
    pub(super) fn rolling_clusters(&self) -> Vec<Vec<LinkId>> {
        let of = |rolling: &Rolling| {
            let ends = rolling.ends.iter().map(|(end, _)| end.link());
            let links = ends.chain([rolling.carrier]);
            let mut bases: Vec<LinkId> = links.map(|link| self.clusters.base(link)).collect();
            bases.sort_unstable();
            bases.dedup();
            bases
        };
        let rollings = self.structure.rollings.iter();
        rollings.filter(|rolling| self.ties_clusters(rolling)).map(of).collect()
    }

    /// Whether a gear, belt or rack ties anything unknown. One that moves a wheel has nothing left to say: its other wheel may keep its
    /// direction on the carrier by slides, without being joined to it.
    fn ties_clusters(&self, rolling: &Rolling) -> bool {
        rolling.ends.iter().any(|&(end, _)| {
            let quantity = quantity(rolling, end);
            self.relations.value(&quantity).is_none()
        })
    }

    /// Finds a ring whose unknown directions or displacements rolling ties, so that two unknowns remain.
    pub(super) fn tie(&mut self) -> bool {
        if !self.rolls() {
            return false;
        }
        let connections = self.connections();
        let blocks = self.blocks(&connections).into_iter();
        let mut alone = blocks
            .filter(|(rings, _)| rings.len() == 1)
            .filter_map(|block| self.square(self.describe(block)));
        let found = alone.find(|found| !found.ties.is_empty());
        found.map(|found| self.accept(found)).is_some()
    }

    /// The directions and displacements of a loop that rolling ties.
    pub(super) fn ties(&self, rings: &[Vec<Connection>], tree: &[Connection]) -> Vec<Tie> {
        let Some(first) =
            tree.first().map(|connection| self.clusters.base(self.link_of(*connection).0))
        else {
            return Vec::new();
        };
        let turning = self.turning_clusters(rings, tree).into_iter();
        let mut unknowns: Vec<Unknown> = turning.map(Unknown::Direction).collect();
        for connection in rings.iter().flatten() {
            let slide = Unknown::Slide(connection.joint);
            if connection.slides() && !unknowns.contains(&slide) {
                unknowns.push(slide);
            }
        }
        let combination = |unknown: &Unknown| match *unknown {
            Unknown::Direction(base) => LinearForm::turn(first, base),
            Unknown::Slide(joint) => LinearForm::slide(joint),
        };
        let combinations: Vec<LinearForm> = unknowns.iter().map(combination).collect();
        let ties = self.relations.ties(&combinations).into_iter().zip(&unknowns);
        ties.filter_map(|(parts, &of)| {
            let (own, sources) = parts?;
            let parts = own.into_iter().map(|(place, part)| (unknowns[place], part)).collect();
            Some(Tie { of, parts, sources })
        })
        .collect()
    }
}

fn one() -> Rational {
    BigRational::from_integer(1.into())
}

/// The coordinate of a connection, from the first link of its joint to the second.
pub(super) fn coordinate(connection: Connection, (from, to): (LinkId, LinkId)) -> LinearForm {
    match connection.kind {
        ConnectionKind::Revolute => LinearForm::turn(from, to),
        ConnectionKind::Prismatic => LinearForm::slide(connection.joint),
    }
}

/// The linear form that rolling holds constant.
fn relation(rolling: &Rolling) -> LinearForm {
    let ends = rolling.ends.iter();
    ends.fold(LinearForm::default(), |sum, &(end, factor)| {
        sum.plus(&exactly(factor), &quantity(rolling, end))
    })
}

/// Returns the coordinate of a wheel or bar on its carrier, as a linear form.
fn quantity(rolling: &Rolling, end: RollingEnd) -> LinearForm {
    match end {
        RollingEnd::Wheel(wheel) => LinearForm::turn(rolling.carrier, wheel),
        RollingEnd::Bar { slide, forwards: true, .. } => LinearForm::slide(slide),
        RollingEnd::Bar { slide, .. } => {
            LinearForm::default().plus(&-one(), &LinearForm::slide(slide))
        }
    }
}

fn exactly(factor: Factor) -> Rational {
    match factor {
        Factor::Whole(value) => BigRational::from_integer(value.into()),
        Factor::Float(value) => {
            let exact = BigRational::from_float(value);
            exact.unwrap_or_else(|| bug!("something rolls on a radius of {value}"))
        }
    }
}
