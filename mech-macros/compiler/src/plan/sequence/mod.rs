//! The order in which positions become known: welds and motors first, then what gears move, then loops, merging clusters all
//! the while.
//!
//! Merging only ever adds knowledge, so whether everything becomes known does not depend on the order.

mod cam;
mod rolling;

use super::between::{Between, pivot, rings};
use super::cluster::Clusters;
use super::coupled::{self, Block};
use super::knowledge::Knowledge;
use super::linear_relations::{LinearForm, LinearRelations};
use super::step::{Connection, ConnectionKind, Drive, Loop, Source, Step};
use super::tight;
use crate::model::{JointId, JointKind, LinkId, Model, MotorId};
use crate::structure::{Diagnosis, KinematicGraph, Pin, Structure};
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
        return Ok(Sequence {
            steps: search.steps,
            sources: search.sources,
        });
    }
    let (rings, waiting) = (search.rings(), search.open_joints());
    Err(Diagnosis::NotSequential { waiting, rings })
}

struct Search<'m> {
    model: &'m Model,
    structure: &'m Structure,
    graph: KinematicGraph,
    clusters: Clusters,
    steps: Vec<Step>,
    /// The number of loops that were found.
    loops: usize,
    /// For each joint whose coordinate is known, how.
    known: Vec<Option<Knowledge>>,
    /// The relations that rolling makes; empty, and not updated, if nothing rolls.
    relations: LinearRelations,
    sources: Vec<Source>,
    /// Links whose directions relative to each other are given by what was known before anything rolled: they slide on each
    /// other, or their clusters were merged. A joint between them has no start of its own to be chosen.
    aligned: UnionFind<usize>,
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
            steps: Vec::new(),
            loops: 0,
            known: vec![None; model.joints.len()],
            relations: LinearRelations::default(),
            sources: Vec::new(),
            aligned: UnionFind::new(model.links.len()),
            behind: Vec::new(),
        };
        search.open_ledger();
        search
    }

    fn link_of(&self, connection: Connection) -> (LinkId, LinkId) {
        (
            self.model.axis(connection.from).link,
            self.model.axis(connection.to).link,
        )
    }

    fn weld(&mut self) {
        for joint in self.model.joint_ids() {
            if let JointKind::Weld(from, to) = self.model.joint(joint).kind {
                let connection = Connection {
                    kind: ConnectionKind::Revolute,
                    from,
                    to,
                    joint,
                };
                let (a, b) = self.link_of(connection);
                if !self.clusters.are_joined(a, b) {
                    self.merge(&[a, b], &Knowledge::default());
                    self.steps.push(Step::Weld(connection));
                }
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
        let connection = Connection {
            kind,
            from,
            to,
            joint,
        };
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
        let whole = self.clusters.merge(&bases);
        for base in bases {
            self.aligned.union(whole.index(), base.index());
        }
        for joint in self.model.joint_ids() {
            let (a, b) = self.model.ends(joint);
            if self.clusters.are_joined(a, b) {
                self.known[joint.index()].get_or_insert_with(|| how.clone());
            }
        }
    }

    /// The knowledge of these joints.
    fn knowledge(&self, joints: &[JointId]) -> Knowledge {
        Knowledge::of(
            joints
                .iter()
                .filter_map(|joint| self.known[joint.index()].as_ref()),
        )
    }

    /// Finds loops of three unknowns, or of two where everything slides: of the lowest level, in the order of declaration.
    fn close(&mut self) -> bool {
        let rings = rings(self.model, &self.connections());
        let mut found: Vec<Loop> = rings.into_iter().map(|ring| self.describe(ring)).collect();
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

    /// Solves what waits for each other together, if that is allowed; or what is held more than once.
    fn couple(&mut self) -> bool {
        let connections = self.connections();
        let allow = self.model.allow;
        let redundant = allow
            .redundant
            .then(|| coupled::redundant_block(&connections))
            .flatten();
        let found = match redundant {
            Some(block) => self.describe(block),
            None if allow.coupled => {
                let found = self.blocks(&connections).into_iter();
                let mut found = found.map(|block| self.describe(block));
                match found.find(|found| self.is_square(found)) {
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

    /// Whether a loop has as many unknowns as equations: the directions, and the displacements of slides, that nothing ties.
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
        for connection in rings
            .iter()
            .flatten()
            .filter(|connection| connection.slides())
        {
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

    fn describe(&self, (rings, tree): Block) -> Loop {
        let members = self.members(&rings);
        let before = self.knowledge(&members);
        let ties = if self.rolls() && rings.iter().any(|ring| ring.len() > 3) {
            self.ties(&rings, &tree)
        } else {
            Vec::new()
        };
        Loop {
            rings,
            tree,
            ties,
            members,
            level: before.level + 1,
            needs: before.needs,
        }
    }

    fn accept(&mut self, found: Loop) {
        let how = Knowledge {
            needs: vec![self.loops],
            level: found.level,
        };
        let bases: Vec<LinkId> = found
            .tree
            .iter()
            .map(|&connection| self.clusters.base(self.link_of(connection).1))
            .collect();
        let first = self.clusters.base(self.link_of(found.first()).0);
        for &base in &bases {
            let angle = Source::Angle {
                from: first,
                to: base,
            };
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

    /// All connections between different clusters, ordered by the bases of these.
    fn connections(&self) -> Vec<Between> {
        let mut between: Vec<Between> = Vec::new();
        let mut add = |connection: Connection, pin: Option<usize>| {
            let (from, to) = self.link_of(connection);
            let (a, b) = (self.clusters.base(from), self.clusters.base(to));
            let (a, b, connection) = if a < b {
                (a, b, connection)
            } else {
                (b, a, connection.reverse())
            };
            if a != b {
                between.push(Between {
                    a,
                    b,
                    connection,
                    pin,
                });
            }
        };
        for (number, pin) in self.structure.pins.iter().enumerate() {
            for (index, &(a, _)) in pin.members.iter().enumerate() {
                for &(b, _) in &pin.members[index + 1..] {
                    if let Some(connection) = pivot(pin, a, b) {
                        add(
                            Connection {
                                joint: self.named_on(pin, a, b),
                                ..connection
                            },
                            Some(number),
                        );
                    }
                }
            }
        }
        for joint in self.model.joint_ids() {
            if let JointKind::Prismatic(from, to) = self.model.joint(joint).kind {
                add(
                    Connection {
                        kind: ConnectionKind::Prismatic,
                        from,
                        to,
                        joint,
                    },
                    None,
                );
            }
        }
        between.sort_by_key(|between| (between.a, between.b));
        // Of several links of one cluster on one pin, one stands for all.
        between.dedup_by(|next, first| {
            next.pin.is_some() && (next.a, next.b, next.pin) == (first.a, first.b, first.pin)
        });
        between
    }

    /// The declared joint of a pin that joins these two links, or else one that joins their clusters, or else one that
    /// holds the second, or else the first.
    fn named_on(&self, pin: &Pin, a: LinkId, b: LinkId) -> JointId {
        let ends = |joint: JointId| self.model.ends(joint);
        let bases = |joint| {
            let (x, y) = ends(joint);
            (self.clusters.base(x), self.clusters.base(y))
        };
        let wanted = (self.clusters.base(a), self.clusters.base(b));
        let direct = |joint: &&JointId| ends(**joint) == (a, b) || ends(**joint) == (b, a);
        let between =
            |joint: &&JointId| bases(**joint) == wanted || bases(**joint) == (wanted.1, wanted.0);
        let holds = |joint: &&JointId| ends(**joint).0 == b || ends(**joint).1 == b;
        let found = pin.joints.iter().find(direct);
        let found = found
            .or_else(|| pin.joints.iter().find(between))
            .or_else(|| pin.joints.iter().find(holds));
        found.copied().unwrap_or(pin.joints[0])
    }

    /// The joints of the rings: the unknown ones, and paths through the clusters between them.
    fn members(&self, rings: &[Vec<Connection>]) -> Vec<JointId> {
        let mut members: Vec<JointId> = Vec::new();
        for ring in rings {
            for (index, connection) in ring.iter().enumerate() {
                let next = ring[(index + 1) % ring.len()];
                let (from, to) = (
                    self.model.axis(connection.to).link,
                    self.model.axis(next.from).link,
                );
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
    fn rings(&self) -> Vec<Vec<JointId>> {
        let blocks = self.blocks(&self.connections());
        let rings = blocks.iter().flat_map(|(rings, _)| rings);
        rings
            .map(|ring| ring.iter().map(|connection| connection.joint).collect())
            .collect()
    }
}
