//! The connections whose coordinates are unknown. They are kept up to date while clusters merge: in a long chain, most stay as they were.

use crate::model::{JointId, JointKind, LinkId, Model};
use crate::plan::between::{Between, Block, pivot, ring_of_three, ring_of_two};
use crate::plan::cluster::Clusters;
use crate::plan::step::{Connection, ConnectionKind};
use crate::stop;
use crate::structure::{Pin, Structure};
use std::collections::{BTreeMap, BTreeSet};

/// Two clusters, by their bases, the lower first.
type Pair = (LinkId, LinkId);

/// A connector of links, which may connect clusters.
#[derive(Clone, Copy)]
enum Connector {
    /// All links on a pin, by its number.
    Pin(usize),
    /// A sliding joint.
    Slide(Connection),
}

/// All connections between different clusters, and the rings that they form.
pub(super) struct Open {
    connectors: Vec<Connector>,
    /// For each link the connectors that it is on.
    of_link: Vec<Vec<usize>>,
    /// For each connector the pairs of clusters that it connects.
    pairs_of: Vec<Vec<Pair>>,
    /// For each pair of clusters its connections, in the order of the connectors.
    pairs: BTreeMap<Pair, BTreeMap<usize, Between>>,
    /// For each cluster those it is connected with.
    neighbours: BTreeMap<LinkId, BTreeSet<LinkId>>,
    rings: BTreeMap<[LinkId; 3], Block>,
    /// Links that have come to another cluster, of which nothing is known here yet.
    moved: Vec<LinkId>,
}

impl Open {
    pub(super) fn new(model: &Model, structure: &Structure) -> Self {
        let pins = (0..structure.pins.len()).map(Connector::Pin);
        let slides = model.joint_ids().filter_map(|joint| {
            let JointKind::Prismatic(from, to) = model.joint(joint).kind else {
                return None;
            };
            let kind = ConnectionKind::Prismatic;
            Some(Connector::Slide(Connection {
                kind,
                from,
                to,
                joint,
            }))
        });
        let connectors: Vec<Connector> = pins.chain(slides).collect();
        let mut of_link = vec![Vec::new(); model.links.len()];
        for (number, connector) in connectors.iter().enumerate() {
            for link in links(model, structure, connector) {
                of_link[link.index()].push(number);
            }
        }
        Self {
            pairs_of: vec![Vec::new(); connectors.len()],
            connectors,
            of_link,
            pairs: BTreeMap::new(),
            neighbours: BTreeMap::new(),
            rings: BTreeMap::new(),
            moved: model.link_ids().collect(),
        }
    }

    /// Takes note that links have come to another cluster.
    pub(super) fn note(&mut self, moved: impl IntoIterator<Item = LinkId>) {
        self.moved.extend(moved);
    }

    /// Brings connections and rings up to what the clusters are by now.
    pub(super) fn update(&mut self, model: &Model, structure: &Structure, clusters: &Clusters) {
        let moved = std::mem::take(&mut self.moved).into_iter();
        let touched: BTreeSet<usize> = moved
            .flat_map(|link| self.of_link[link.index()].iter().copied())
            .collect();
        let mut changed: BTreeSet<Pair> = BTreeSet::new();
        for &number in &touched {
            stop::check();
            for pair in std::mem::take(&mut self.pairs_of[number]) {
                changed.insert(pair);
                self.remove(pair, number);
            }
        }
        for &number in &touched {
            for between in self.betweens(model, structure, clusters, number) {
                let pair = (between.a, between.b);
                changed.insert(pair);
                self.insert(pair, number, between);
            }
        }
        for pair in changed {
            stop::check();
            self.find_rings(pair);
        }
    }

    /// All connections, ordered by the bases of their clusters.
    pub(super) fn connections(&self) -> Vec<Between> {
        let pairs = self.pairs.values();
        pairs.flat_map(BTreeMap::values).copied().collect()
    }

    /// All rings of three connections, and of two that slide, ordered by the bases of their clusters.
    pub(super) fn rings(&self) -> impl Iterator<Item = &Block> {
        self.rings.values()
    }

    fn remove(&mut self, pair: Pair, number: usize) {
        let (a, b) = pair;
        let Some(connections) = self.pairs.get_mut(&pair) else {
            return;
        };
        connections.remove(&number);
        if !connections.is_empty() {
            return;
        }
        self.pairs.remove(&pair);
        // Two clusters that are no longer a pair are in no ring together.
        for third in self.common_neighbours(pair) {
            self.rings.remove(&sorted([a, b, third]));
        }
        self.rings.remove(&[a, b, b]);
        for (one, other) in [(a, b), (b, a)] {
            if let Some(others) = self.neighbours.get_mut(&one) {
                others.remove(&other);
            }
        }
    }

    fn insert(&mut self, pair: Pair, number: usize, between: Between) {
        self.pairs.entry(pair).or_default().insert(number, between);
        self.pairs_of[number].push(pair);
        let (a, b) = pair;
        self.neighbours.entry(a).or_default().insert(b);
        self.neighbours.entry(b).or_default().insert(a);
    }

    /// The clusters that both of a pair are connected with.
    fn common_neighbours(&self, (a, b): Pair) -> Vec<LinkId> {
        let of = |base: LinkId| self.neighbours.get(&base);
        let (Some(first), Some(second)) = (of(a), of(b)) else {
            return Vec::new();
        };
        // The ground may have very many.
        let [few, many] = if first.len() < second.len() {
            [first, second]
        } else {
            [second, first]
        };
        few.iter()
            .copied()
            .filter(|base| many.contains(base))
            .collect()
    }

    /// Finds the rings anew that a pair of clusters is in.
    fn find_rings(&mut self, pair: Pair) {
        let (a, b) = pair;
        let found = self.between(pair).collect::<Vec<Between>>();
        let found = found.windows(2);
        let found = found.filter_map(|two| ring_of_two(two[0], two[1]));
        self.set_ring([a, b, b], found.into_iter().next());
        for third in self.common_neighbours(pair) {
            let bases = sorted([a, b, third]);
            self.set_ring(bases, self.ring_of_three(bases));
        }
    }

    /// Notes the ring of these clusters, or that there is none.
    fn set_ring(&mut self, bases: [LinkId; 3], ring: Option<Block>) {
        match ring {
            Some(ring) => self.rings.insert(bases, ring),
            None => self.rings.remove(&bases),
        };
    }

    fn ring_of_three(&self, [low, middle, high]: [LinkId; 3]) -> Option<Block> {
        let far = self.between((low, high)).next()?;
        let across = self.between((middle, high));
        let mut found = across.flat_map(|across| {
            let near = self.between((low, middle));
            near.filter_map(move |near| ring_of_three(near, across, far))
        });
        found.next()
    }

    /// The connections of a pair of clusters.
    fn between(&self, pair: Pair) -> impl Iterator<Item = Between> + '_ {
        let connections = self.pairs.get(&pair).into_iter();
        connections.flat_map(BTreeMap::values).copied()
    }

    /// Returns the connections that a connector makes by now. If several links of one cluster are on a pin, one stands for all.
    fn betweens(
        &self,
        model: &Model,
        structure: &Structure,
        clusters: &Clusters,
        number: usize,
    ) -> Vec<Between> {
        let mut found: BTreeMap<Pair, Between> = BTreeMap::new();
        let mut add = |connection: Connection, pin: Option<usize>| {
            let base = |axis| clusters.base(model.axis(axis).link);
            let (a, b) = (base(connection.from), base(connection.to));
            let (a, b, connection) = if a < b {
                (a, b, connection)
            } else {
                (b, a, connection.reverse())
            };
            if a != b {
                let heading = structure.parallels.of(connection.joint);
                found.entry((a, b)).or_insert(Between {
                    a,
                    b,
                    connection,
                    pin,
                    direction: heading.map(|heading| heading.number),
                });
            }
        };
        match self.connectors[number] {
            Connector::Pin(number) => {
                let pin = &structure.pins[number];
                for (index, &(a, _)) in pin.members.iter().enumerate() {
                    for &(b, _) in &pin.members[index + 1..] {
                        if let Some(connection) = pivot(pin, a, b) {
                            let joint = named_on(model, clusters, pin, a, b);
                            add(
                                Connection {
                                    joint,
                                    ..connection
                                },
                                Some(number),
                            );
                        }
                    }
                }
            }
            Connector::Slide(connection) => add(connection, None),
        }
        found.into_values().collect()
    }
}

fn sorted(mut bases: [LinkId; 3]) -> [LinkId; 3] {
    bases.sort_unstable();
    bases
}

/// The links that a connector is on.
fn links(model: &Model, structure: &Structure, connector: &Connector) -> Vec<LinkId> {
    match *connector {
        Connector::Pin(number) => {
            let members = structure.pins[number].members.iter();
            members.map(|(link, _)| *link).collect()
        }
        Connector::Slide(connection) => {
            let axes = [connection.from, connection.to];
            axes.map(|axis| model.axis(axis).link).to_vec()
        }
    }
}

/// The declared joint of a pin by which the connection of two links is named: one that joins them, else their clusters, else one that
/// holds the second, else the first.
pub(super) fn named_on(
    model: &Model,
    clusters: &Clusters,
    pin: &Pin,
    a: LinkId,
    b: LinkId,
) -> JointId {
    let ends = |joint: JointId| model.ends(joint);
    let bases = |joint| {
        let (x, y) = ends(joint);
        (clusters.base(x), clusters.base(y))
    };
    let wanted = (clusters.base(a), clusters.base(b));
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
