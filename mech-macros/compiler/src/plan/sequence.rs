//! The order in which positions become known: motors first, then gears, then loops, merging clusters all the while.
//!
//! Merging only ever adds knowledge, so whether everything becomes known does not depend on the order.

use super::cluster::Clusters;
use super::step::{Connection, ConnectionKind, Drive, Loop, Mesh, Step};
use crate::model::{JointId, JointKind, LinkId, Model};
use crate::structure::{Diagnosis, Gear, KinematicGraph, Pin, Structure};

/// Finds the steps.
pub(super) fn sequence(model: &Model, structure: &Structure) -> Result<Vec<Step>, Diagnosis> {
    let mut search = Search::new(model, structure);
    for motor in model.motor_ids() {
        search.drive(motor);
    }
    loop {
        let meshed = search.mesh();
        if !meshed && !search.close() {
            break;
        }
    }
    if search.clusters.is_one() {
        Ok(search.steps)
    } else {
        Err(Diagnosis::NotSequential {
            waiting: search.waiting(),
        })
    }
}

/// On which loops a known coordinate depends directly, and how many loops lead to it one after the other.
#[derive(Clone, Debug, Default)]
struct Knowledge {
    needs: Vec<usize>,
    level: usize,
}

impl Knowledge {
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

struct Search<'m> {
    model: &'m Model,
    structure: &'m Structure,
    graph: KinematicGraph,
    clusters: Clusters,
    steps: Vec<Step>,
    /// How many loops were found.
    loops: usize,
    /// For each joint whose coordinate is known, how.
    known: Vec<Option<Knowledge>>,
    gears: Vec<Gear>,
}

impl<'m> Search<'m> {
    fn new(model: &'m Model, structure: &'m Structure) -> Self {
        Self {
            model,
            structure,
            graph: KinematicGraph::new(model),
            clusters: Clusters::new(model.links.len()),
            steps: Vec::new(),
            loops: 0,
            known: vec![None; model.joints.len()],
            gears: structure.gears.clone(),
        }
    }

    fn link_of(&self, connection: Connection) -> (LinkId, LinkId) {
        (
            self.model.axis(connection.from).link,
            self.model.axis(connection.to).link,
        )
    }

    fn drive(&mut self, motor: crate::model::MotorId) {
        let joint = self.model.motor(motor).joint;
        let (kind, from, to) = match self.model.joint(joint).kind {
            JointKind::Revolute(a, b) => (ConnectionKind::Revolute, a, b),
            JointKind::Prismatic(a, b) => (ConnectionKind::Prismatic, a, b),
            // `syntax` lets no motor on a gear.
            JointKind::Gear { .. } => return,
        };
        let connection = Connection {
            kind,
            from,
            to,
            joint,
        };
        let (a, b) = self.link_of(connection);
        if !self.clusters.joined(a, b) {
            self.merge(&[a, b], &Knowledge::default());
            self.steps.push(Step::Drive(Drive { motor, connection }));
        }
    }

    /// Merges the clusters of these links. All joints between them are known by that.
    fn merge(&mut self, links: &[LinkId], how: &Knowledge) {
        let bases: Vec<LinkId> = links.iter().map(|&link| self.clusters.base(link)).collect();
        self.clusters.merge(&bases);
        for joint in self.model.joint_ids() {
            let (a, b) = self.model.ends(joint);
            if self.clusters.joined(a, b) {
                self.known[joint.index()].get_or_insert_with(|| how.clone());
            }
        }
    }

    /// What is known of the way between two links of the same cluster.
    fn knowledge(&self, joints: &[JointId]) -> Knowledge {
        Knowledge::of(
            joints
                .iter()
                .filter_map(|joint| self.known[joint.index()].as_ref()),
        )
    }

    /// Solves every gear one of whose wheels is known on its carrier.
    fn mesh(&mut self) -> bool {
        let mut found = false;
        while let Some(index) = self
            .gears
            .iter()
            .position(|gear| self.turns(gear).is_some())
        {
            let gear = self.gears.remove(index);
            if let Some((input, output, speed)) = self.turns(&gear) {
                let (carrier, wheel) = self.link_of(output);
                let (from, to) = self.link_of(input);
                let how = self.knowledge(&self.way(from, to));
                self.merge(&[carrier, wheel], &how);
                self.steps.push(Step::Mesh(Mesh {
                    gear: gear.joint,
                    input,
                    output,
                    speed,
                }));
                found = true;
            }
        }
        found
    }

    /// The pins of the known and of the unknown wheel, if there is one of each.
    fn turns(&self, gear: &Gear) -> Option<(Connection, Connection, f64)> {
        let known = |wheel| self.clusters.joined(gear.carrier, wheel);
        let on = |(wheel, pin): (LinkId, usize)| {
            let pin = &self.structure.pins[pin];
            let connection = pivot(pin, gear.carrier, wheel)?;
            Some(Connection {
                joint: self.named_on(pin, gear.carrier, wheel),
                ..connection
            })
        };
        let speed = gear.ratio.speed();
        match (known(gear.a.0), known(gear.b.0)) {
            (true, false) => Some((on(gear.a)?, on(gear.b)?, speed)),
            (false, true) => Some((on(gear.b)?, on(gear.a)?, speed.recip())),
            _ => None,
        }
    }

    /// Finds one loop of three unknowns, the lowest in level, then the earliest declared.
    fn close(&mut self) -> bool {
        let connections = self.connections();
        let mut best: Option<(Loop, Knowledge)> = None;
        for (i, &first) in connections.iter().enumerate() {
            for &second in &connections[i + 1..] {
                let Some(ring) = ring(first, second, &connections) else {
                    continue;
                };
                let members = self.members(&ring);
                let before = self.knowledge(&members);
                if best
                    .as_ref()
                    .is_none_or(|(_, known)| before.level < known.level)
                {
                    let (level, needs) = (before.level + 1, before.needs.clone());
                    best = Some((
                        Loop {
                            ring,
                            members,
                            level,
                            needs,
                        },
                        before,
                    ));
                }
            }
        }
        let Some((found, _)) = best else { return false };
        let how = Knowledge {
            needs: vec![self.loops],
            level: found.level,
        };
        self.merge(
            &found.ring.map(|connection| self.link_of(connection).0),
            &how,
        );
        self.loops += 1;
        self.steps.push(Step::Close(found));
        true
    }

    /// All pairs of clusters that one unknown connection joins, by their bases.
    fn connections(&self) -> Vec<Between> {
        let mut between: Vec<Between> = Vec::new();
        let mut add = |connection: Connection, pin| {
            let (from, to) = self.link_of(connection);
            let (a, b) = (self.clusters.base(from), self.clusters.base(to));
            let (a, b, connection) = if a < b {
                (a, b, connection)
            } else {
                (b, a, connection.reversed())
            };
            if a != b && between.iter().all(|known| (known.a, known.b) != (a, b)) {
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
        between
    }

    /// The declared joint of a pin that joins these two links, or else one that joins their clusters, or else one that
    /// holds the second.
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

    /// The joints of the cycle: the unknown ones, and ways through the clusters between them.
    fn members(&self, ring: &[Connection; 3]) -> Vec<JointId> {
        let mut members = Vec::new();
        for (index, connection) in ring.iter().enumerate() {
            let next = ring[(index + 1) % 3];
            let (from, to) = (
                self.model.axis(connection.to).link,
                self.model.axis(next.from).link,
            );
            members.push(connection.joint);
            members.extend(self.way(from, to));
        }
        members
    }

    /// A way through known joints between two links of the same cluster: of the lowest level, then the shortest.
    fn way(&self, from: LinkId, to: LinkId) -> Vec<JointId> {
        let level = |joint: JointId| self.known[joint.index()].as_ref().map(|known| known.level);
        let is_gear = |joint| matches!(self.model.joint(joint).kind, JointKind::Gear { .. });
        let open = |joint, most| level(joint).is_some_and(|level| level <= most) && !is_gear(joint);
        let ways = (0..=self.loops).map(|most| self.graph.way(from, to, |joint| open(joint, most)));
        ways.into_iter()
            .find(|way| !way.is_empty() || from == to)
            .unwrap_or_default()
    }

    /// The joints between different clusters.
    fn waiting(&self) -> Vec<JointId> {
        let apart = |joint: &JointId| {
            let (a, b) = self.model.ends(*joint);
            !self.clusters.joined(a, b)
        };
        self.model.joint_ids().filter(apart).collect()
    }
}

/// The connection of two links on a pin, named by the pin's first joint.
fn pivot(pin: &Pin, from: LinkId, to: LinkId) -> Option<Connection> {
    let (from, to) = (pin.axis_of(from)?, pin.axis_of(to)?);
    Some(Connection {
        kind: ConnectionKind::Revolute,
        from,
        to,
        joint: *pin.joints.first()?,
    })
}

/// Two clusters, by their bases, the lower first, and the unknown connection that joins them.
#[derive(Clone, Copy)]
struct Between {
    a: LinkId,
    b: LinkId,
    connection: Connection,
    pin: Option<usize>,
}

/// The ring that two connections form with a third, if there is one. It starts at the cluster with the lowest base,
/// which is the ground's if the ground is in the ring.
fn ring(first: Between, second: Between, all: &[Between]) -> Option<[Connection; 3]> {
    // The list is sorted by bases with the lower first, so the ring's lowest cluster is the first of both.
    if first.a != second.a || first.b == second.b {
        return None;
    }
    let (near, far) = if first.b < second.b {
        (first, second)
    } else {
        (second, first)
    };
    let across = all
        .iter()
        .find(|known| (known.a, known.b) == (near.b, far.b))?;
    // Three clusters on one pin are no loop, and three slides say only two things.
    let one_pin = near.pin.is_some() && near.pin == far.pin && far.pin == across.pin;
    let ring = [
        near.connection,
        across.connection,
        far.connection.reversed(),
    ];
    let turns = ring
        .iter()
        .any(|connection| connection.kind == ConnectionKind::Revolute);
    (turns && !one_pin).then_some(ring)
}
