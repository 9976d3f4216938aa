//! The order in which positions become known: welds and motors first, then what gears move, then loops, merging clusters all
//! the while.
//!
//! Merging only ever adds knowledge, so whether everything becomes known does not depend on the order.

mod cam;
mod open;
mod rolling;
mod slides;

use super::between::{Between, Block};
use super::cluster::Clusters;
use super::linear_relations::{LinearForm, LinearRelations};
use super::step::{Connection, ConnectionKind, Drive, Loop, Source, Step, Weld};
use super::{coupled, tight};
use crate::bug::bug;
use crate::cancel;
use crate::model::{JointId, JointKind, LinkId, Model, MotorId};
use crate::structure::{Diagnosis, KinematicGraph, Structure};
use open::{Known, Open};
use petgraph::unionfind::UnionFind;
use rolling::coordinate;

/// The steps, and the sources of gears, belts and racks.
pub(super) struct Sequence {
    pub(super) steps: Vec<Step>,
    pub(super) sources: Vec<Source>,
}

/// Finds the steps.
pub(super) fn sequence(model: &Model, structure: &Structure) -> Result<Sequence, Diagnosis> {
    let mut search = Search::new(model, structure);
    search.weld();
    for motor in model.motor_ids() {
        search.drive(motor);
    }
    while search.mesh() || search.cam() || search.close() || search.tie() || search.couple() {}
    if let Some(joint) = search.idle_cam() {
        return Err(Diagnosis::CamNotDriven { joint });
    }
    if search.clusters.is_one() {
        return Ok(Sequence { steps: search.steps, sources: search.sources });
    }
    let (rings, waiting) = (search.rings(), search.open_joints());
    Err(Diagnosis::NotSequential { waiting, rings })
}

struct Search<'m> {
    model: &'m Model,
    structure: &'m Structure,
    graph: KinematicGraph,
    clusters: Clusters,
    /// The connections between them.
    open: Open,
    steps: Vec<Step>,
    /// The number of loops that were found.
    loops: usize,
    /// For each joint whose coordinate is known, how.
    known: Vec<Option<Knowledge>>,
    /// Whether rolling or a cam ties any coordinates: then relations between them are kept.
    keeps_ledger: bool,
    /// The relations that rolling makes; empty, and not updated, if nothing rolls.
    relations: LinearRelations,
    sources: Vec<Source>,
    /// Links whose directions relative to each other are given by what was known before anything rolled: they slide on each
    /// other, or their clusters were merged. A joint between them has no start of its own to be chosen.
    aligned: UnionFind<usize>,
    /// Links that form one body: they are welded, or a loop of bodies without a motor holds them.
    bodies: UnionFind<usize>,
    /// For each source, what it depends on.
    behind: Vec<Knowledge>,
}

impl<'m> Search<'m> {
    fn new(model: &'m Model, structure: &'m Structure) -> Self {
        let mut search = Self {
            model,
            structure,
            graph: KinematicGraph::new(model),
            clusters: Clusters::new(model.links.len()),
            open: Open::new(model, structure),
            steps: Vec::new(),
            loops: 0,
            known: vec![None; model.joints.len()],
            keeps_ledger: !structure.rollings.is_empty() || model.cams().next().is_some(),
            relations: LinearRelations::default(),
            sources: Vec::new(),
            aligned: UnionFind::new(model.links.len()),
            bodies: UnionFind::new(model.links.len()),
            behind: Vec::new(),
        };
        search.open_ledger();
        search
    }

    fn link_of(&self, connection: Connection) -> (LinkId, LinkId) {
        (self.model.axis(connection.from).link, self.model.axis(connection.to).link)
    }

    fn weld(&mut self) {
        let welds = self.model.joint_ids().filter_map(|joint| {
            let welded = matches!(self.model.joint(joint).kind, JointKind::Weld(..));
            welded.then_some((joint, [1.0, 0.0]))
        });
        let still = &self.structure.still;
        let still = still.iter().map(|pin| (pin.joint, pin.direction));
        let all: Vec<(JointId, [f64; 2])> = welds.chain(still).collect();
        for (joint, direction) in all {
            let (JointKind::Weld(from, to) | JointKind::Revolute(from, to)) =
                self.model.joint(joint).kind
            else {
                bug!("what never turns neither is welded nor has a pin");
            };
            let connection = Connection { kind: ConnectionKind::Revolute, from, to, joint };
            let (a, b) = self.link_of(connection);
            if !self.clusters.are_joined(a, b) {
                self.merge(&[a, b], &Knowledge::default());
                self.bodies.union(a.index(), b.index());
                self.steps.push(Step::Weld(Weld { connection, direction }));
            }
        }
    }

    fn drive(&mut self, motor: MotorId) {
        let joint = self.model.motor(motor).joint;
        let (kind, from, to) = match self.model.joint(joint).kind {
            JointKind::Revolute(a, b) => (ConnectionKind::Revolute, a, b),
            JointKind::Prismatic(a, b) => (ConnectionKind::Prismatic, a, b),
            // `syntax` lets no motor on anything else.
            _ => return,
        };
        let connection = Connection { kind, from, to, joint };
        let (a, b) = self.link_of(connection);
        if !self.clusters.are_joined(a, b) {
            self.source(
                Source::Motor(motor),
                &coordinate(connection, (a, b)),
                Knowledge::default(),
            );
            self.turned_slide(joint, &Knowledge::default());
            self.merge(&[a, b], &Knowledge::default());
            self.steps.push(Step::Drive(Drive { motor, connection }));
        }
    }

    /// Merges the clusters of these links. All joints between them are known by that.
    fn merge(&mut self, links: &[LinkId], how: &Knowledge) {
        let bases: Vec<LinkId> = links.iter().map(|&link| self.clusters.base(link)).collect();
        let Some(whole) = bases.iter().copied().min() else {
            bug!("no links are merged");
        };
        let coming = bases.iter().filter(|&&base| base != whole);
        let coming = coming.flat_map(|&base| self.clusters.links(base));
        let moved: Vec<LinkId> = coming.collect();
        self.clusters.merge(&bases);
        for base in bases {
            self.aligned.union(whole.index(), base.index());
        }
        for &link in &moved {
            for (joint, other) in self.graph.joints(link) {
                if self.clusters.base(other) == whole {
                    self.known[joint.index()].get_or_insert_with(|| how.clone());
                }
            }
        }
        self.open.note(moved);
    }

    /// The knowledge of these joints.
    fn knowledge(&self, joints: &[JointId]) -> Knowledge {
        Knowledge::of(joints.iter().filter_map(|joint| self.known[joint.index()].as_ref()))
    }

    /// Accepts loops of three clusters, or of two that slide: of those found, the ones of the lowest level, in the order of declaration.
    fn close(&mut self) -> bool {
        cancel::check();
        self.update();
        let rings = self.open.rings();
        let mut found: Vec<Loop> = rings.map(|ring| self.describe(ring.clone())).collect();
        let Some(lowest) = found.iter().map(|closing| closing.level).min() else {
            return false;
        };
        found.retain(|closing| closing.level == lowest);
        for closing in found {
            // One that was just accepted may have taken its clusters.
            let ends = closing.tree.iter();
            let ends: Vec<(LinkId, LinkId)> =
                ends.map(|&connection| self.link_of(connection)).collect();
            let joined = |a, b| self.clusters.are_joined(a, b);
            let apart = ends.iter().all(|&(from, to)| !joined(from, to));
            let distinct = ends.windows(2).all(|pair| !joined(pair[0].1, pair[1].1));
            if apart && distinct {
                self.accept(closing);
            }
        }
        true
    }

    /// Accepts a block of loops to be solved together, if that is allowed, or joints that hold more than once.
    fn couple(&mut self) -> bool {
        let connections = self.connections();
        let allow = self.model.allow;
        let redundant = allow.redundant.then(|| coupled::redundant_block(&connections)).flatten();
        let found = match redundant {
            Some(block) => self.describe(block),
            None if allow.coupled => {
                let found = self.blocks(&connections).into_iter();
                let mut found = found.filter_map(|block| self.square(self.describe(block)));
                match found.next() {
                    Some(found) => found,
                    None => return false,
                }
            }
            None => return false,
        };
        self.accept(found);
        true
    }

    /// The blocks that have to be solved together: one for each smallest set of clusters that hold each other.
    fn blocks(&self, connections: &[Between]) -> Vec<Block> {
        tight::sets(connections, &self.rolling_clusters())
            .iter()
            .filter_map(|set| coupled::block(connections, set))
            .collect()
    }

    /// Whether a loop has as many unknowns as equations. Unknowns are directions and displacements that nothing ties.
    fn is_square(&self, closing: &Loop) -> bool {
        let slides = closing.connections().filter(Connection::slides).count();
        self.turning_clusters(&closing.rings, &closing.tree).len() + slides
            == 2 * closing.rings.len() + closing.ties.len()
    }

    /// The clusters of a loop that turn by themselves, seen from the first: one for each set of clusters that slide on each
    /// other.
    fn turning_clusters(&self, rings: &[Vec<Connection>], tree: &[Connection]) -> Vec<LinkId> {
        let base = |axis| self.clusters.base(self.model.axis(axis).link);
        let mut classes = UnionFind::<usize>::new(self.model.links.len());
        for connection in rings.iter().flatten().filter(|connection| connection.slides()) {
            classes.union(base(connection.from).index(), base(connection.to).index());
        }
        let mut turning: Vec<LinkId> = Vec::new();
        let Some(first) = tree.first().map(|connection| base(connection.from)) else {
            return turning;
        };
        for cluster in tree.iter().map(|connection| base(connection.to)) {
            let same = |other: LinkId| classes.equiv(other.index(), cluster.index());
            if !same(first) && !turning.iter().any(|&other| same(other)) {
                turning.push(cluster);
            }
        }
        turning
    }

    fn describe(&self, block: Block) -> Loop {
        let (rings, tree) = self.rooted(block);
        let members = self.members(&rings);
        let before = self.knowledge(&members);
        // A ring of three has two unknowns, unless it only slides.
        let slides = |ring: &Vec<Connection>| ring.iter().all(Connection::slides);
        let is_long = |ring: &Vec<Connection>| ring.len() > 3 || ring.len() == 3 && slides(ring);
        let ties = if self.rolls() && rings.iter().any(is_long) {
            self.ties(&rings, &tree)
        } else {
            Vec::new()
        };
        Loop { rings, tree, ties, members, level: before.level + 1, needs: before.needs }
    }

    /// A ring of three clusters, seen from the first of them that changes its form: where its pins meet, they meet as they do where a motor
    /// on the first cluster makes them meet. What never changes its form stays an arm of constant length.
    fn rooted(&self, (mut rings, mut tree): Block) -> Block {
        let [ring] = &mut rings[..] else {
            return (rings, tree);
        };
        let changes = |&corner: &usize| {
            let [from, to] = self.corner(ring, corner);
            !self.bodies.equiv(from.index(), to.index())
        };
        if ring.len() == 3
            && let Some(first) = (0..3).find(changes).filter(|first| *first > 0)
        {
            ring.rotate_left(first);
            tree = vec![ring[0], ring[2].reverse()];
        }
        (rings, tree)
    }

    /// The links of the cluster at this corner of a ring on which the connections before and behind it are.
    fn corner(&self, ring: &[Connection], corner: usize) -> [LinkId; 2] {
        let before = ring[(corner + ring.len() - 1) % ring.len()];
        [before.to, ring[corner].from].map(|axis| self.model.axis(axis).link)
    }

    /// Takes note that a loop holds its clusters to each other for ever, if each of them is one body.
    fn note_body(&mut self, found: &Loop) {
        let [ring] = &found.rings[..] else { return };
        let corners = (0..ring.len()).map(|corner| self.corner(ring, corner));
        let corners: Vec<[LinkId; 2]> = corners.collect();
        let is_body = |[a, b]: &[LinkId; 2]| self.bodies.equiv(a.index(), b.index());
        if found.ties.is_empty() && corners.iter().all(is_body) {
            for [a, _] in &corners {
                self.bodies.union(corners[0][0].index(), a.index());
            }
        }
    }

    fn accept(&mut self, found: Loop) {
        self.note_body(&found);
        let how = Knowledge { needs: vec![self.loops], level: found.level };
        let bases: Vec<LinkId> = found
            .tree
            .iter()
            .map(|&connection| self.clusters.base(self.link_of(connection).1))
            .collect();
        let first = self.clusters.base(self.link_of(found.first()).0);
        for &base in &bases {
            let angle = Source::Angle { from: first, to: base };
            self.source(angle, &LinearForm::turn(first, base), how.clone());
        }
        for slide in found.connections().filter(Connection::slides) {
            let source = Source::Displacement(slide.joint);
            self.source(source, &LinearForm::slide(slide.joint), how.clone());
        }
        self.merge(&[&[first], &bases[..]].concat(), &how);
        self.loops += 1;
        self.steps.push(Step::Close(found));
    }

    /// All connections between different clusters, ordered by the bases of these, without what follows from others.
    fn connections(&mut self) -> Vec<Between> {
        self.update();
        coupled::drop_parallel(self.open.connections(Known {
            model: self.model,
            structure: self.structure,
            clusters: &self.clusters,
        }))
    }

    fn update(&mut self) {
        self.open.update(Known {
            model: self.model,
            structure: self.structure,
            clusters: &self.clusters,
        });
    }

    /// The joints of the rings: the unknown ones, and paths through the clusters between them.
    fn members(&self, rings: &[Vec<Connection>]) -> Vec<JointId> {
        let mut members: Vec<JointId> = Vec::new();
        for ring in rings {
            for (index, connection) in ring.iter().enumerate() {
                let next = ring[(index + 1) % ring.len()];
                let (from, to) =
                    (self.model.axis(connection.to).link, self.model.axis(next.from).link);
                let path = self.path(from, to);
                for joint in [connection.joint].into_iter().chain(path) {
                    if !members.contains(&joint) {
                        members.push(joint);
                    }
                }
            }
        }
        members
    }

    /// A path of known joints between two links of the same cluster: of the lowest level, then the shortest.
    fn path(&self, from: LinkId, to: LinkId) -> Vec<JointId> {
        self.graph.path(from, to, |joint| {
            let known = self.known[joint.index()].as_ref()?;
            (!self.model.joint(joint).kind.ties()).then_some(known.level)
        })
    }

    /// The joints between different clusters.
    fn open_joints(&self) -> Vec<JointId> {
        let apart = |joint: &JointId| {
            let (a, b) = self.model.ends(*joint);
            !self.clusters.are_joined(a, b) && !self.model.joint(*joint).kind.ties()
        };
        self.model.joint_ids().filter(apart).collect()
    }

    /// The rings that wait for each other, by their unknown joints.
    fn rings(&mut self) -> Vec<Vec<JointId>> {
        let connections = self.connections();
        let blocks = self.blocks(&connections);
        let rings = blocks.iter().flat_map(|(rings, _)| rings);
        rings.map(|ring| ring.iter().map(|connection| connection.joint).collect()).collect()
    }
}

/// On which loops a known coordinate depends directly, and how many loops lead to it one after the other.
#[derive(Clone, Debug, Default)]
struct Knowledge {
    needs: Vec<usize>,
    level: usize,
}

impl Knowledge {
    /// The knowledge of something that depends on all of these.
    fn of<'k>(parts: impl Iterator<Item = &'k Self>) -> Self {
        let mut all = Self::default();
        for part in parts {
            all.needs.extend(&part.needs);
            all.level = all.level.max(part.level);
        }
        all.needs.sort_unstable();
        all.needs.dedup();
        all
    }
}
