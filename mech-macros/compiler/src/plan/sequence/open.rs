//! The connections whose coordinates are unknown. They are kept up to date while clusters merge: in a long chain, most stay as they were.

use crate::cancel;
use crate::model::{JointId, JointKind, LinkId, Model};
use crate::plan::between::{Between, Block, pivot, ring_of_three, ring_of_two};
use crate::plan::cluster::Clusters;
use crate::plan::step::{Connection, ConnectionKind};
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
///
/// What a connector connects is worked out where it is asked for: a pin of many links connects each two of them.
pub(super) struct Open {
    connectors: Vec<Connector>,
    /// For each link the connectors that it is on.
    of_link: Vec<Vec<usize>>,
    /// The cluster of each link, as far as it is known here.
    base: Vec<Option<LinkId>>,
    /// For each connector the clusters on it, each with the first of its links there, which stands for all of them.
    on: Vec<BTreeMap<LinkId, LinkId>>,
    /// For each cluster the connectors that it is on.
    of_cluster: BTreeMap<LinkId, BTreeSet<usize>>,
    rings: BTreeMap<[LinkId; 3], Block>,
    /// For each pair of clusters the third of each ring that both are in.
    thirds: BTreeMap<Pair, BTreeSet<LinkId>>,
    /// Links that have come to another cluster, of which nothing is known here yet.
    moved: Vec<LinkId>,
}

/// What connections are worked out from.
#[derive(Clone, Copy)]
pub(super) struct Known<'k> {
    pub(super) model: &'k Model,
    pub(super) structure: &'k Structure,
    pub(super) clusters: &'k Clusters,
}

impl Open {
    pub(super) fn new(model: &Model, structure: &Structure) -> Self {
        let pins = (0..structure.pins.len()).map(Connector::Pin);
        let slides = model.joint_ids().filter_map(|joint| {
            let JointKind::Prismatic(from, to) = model.joint(joint).kind else {
                return None;
            };
            let kind = ConnectionKind::Prismatic;
            Some(Connector::Slide(Connection { kind, from, to, joint }))
        });
        let connectors: Vec<Connector> = pins.chain(slides).collect();
        let mut of_link = vec![Vec::new(); model.links.len()];
        for (number, &connector) in connectors.iter().enumerate() {
            for link in links(model, structure, connector) {
                of_link[link.index()].push(number);
            }
        }
        Self {
            base: vec![None; model.links.len()],
            on: vec![BTreeMap::new(); connectors.len()],
            connectors,
            of_link,
            of_cluster: BTreeMap::new(),
            rings: BTreeMap::new(),
            thirds: BTreeMap::new(),
            moved: model.link_ids().collect(),
        }
    }

    /// Takes note that links have come to another cluster.
    pub(super) fn note(&mut self, moved: impl IntoIterator<Item = LinkId>) {
        self.moved.extend(moved);
    }

    /// Brings connections and rings up to what the clusters are by now.
    pub(super) fn update(&mut self, known: Known<'_>) {
        let moved = std::mem::take(&mut self.moved);
        let mut touched: BTreeMap<usize, Vec<LinkId>> = BTreeMap::new();
        let mut involved: BTreeSet<LinkId> = BTreeSet::new();
        for &link in &moved {
            involved.extend(self.base[link.index()]);
            involved.insert(known.clusters.base(link));
            for &number in &self.of_link[link.index()] {
                touched.entry(number).or_default().push(link);
            }
        }
        let renewed: Vec<(usize, BTreeSet<LinkId>)> = touched
            .into_iter()
            .map(|(number, links)| (number, self.bring(known, number, &links)))
            .collect();
        for link in moved {
            self.base[link.index()] = Some(known.clusters.base(link));
        }
        let old = self.rings.keys().filter(|ring| ring.iter().any(|base| involved.contains(base)));
        let mut changed: BTreeSet<Pair> =
            old.flat_map(|&[a, b, c]| [(a, b), (a, c), (b, c)]).collect();
        for (number, renewed) in renewed {
            cancel::check();
            changed.extend(self.new_pairs(number, &renewed));
        }
        // Of a ring of two the last stands there twice.
        changed.retain(|(a, b)| a != b);
        for pair in changed {
            cancel::check();
            self.find_rings(known, pair);
        }
    }

    /// Brings links on a connector to the clusters that they are in by now; gives those for which another link stands there than before.
    /// A cluster comes to another as a whole.
    fn bring(&mut self, known: Known<'_>, number: usize, links: &[LinkId]) -> BTreeSet<LinkId> {
        let connector = self.connectors[number];
        let on = &mut self.on[number];
        let mut renewed = BTreeSet::new();
        for &link in links {
            let base = known.clusters.base(link);
            let former = self.base[link.index()].filter(|former| *former != base);
            if let Some(former) = former.filter(|former| on.remove(former).is_some())
                && let Some(connectors) = self.of_cluster.get_mut(&former)
            {
                connectors.remove(&number);
            }
            let is_first =
                |other: &LinkId| first_of(known, connector, [link, *other]) == Some(link);
            if on.get(&base).is_none_or(is_first) {
                on.insert(base, link);
                self.of_cluster.entry(base).or_default().insert(number);
                renewed.insert(base);
            }
        }
        renewed
    }

    /// The pairs of clusters on a connector that may be in a ring with a third, one of them among those that are new there.
    fn new_pairs(&self, number: usize, renewed: &BTreeSet<LinkId>) -> BTreeSet<Pair> {
        /// Of so many pairs each is looked at.
        const FEW: usize = 100;
        let on = &self.on[number];
        let with = |one: LinkId, others: &BTreeSet<LinkId>| {
            let others = others.iter().filter(|other| **other != one);
            others.map(|&other| (one.min(other), one.max(other))).collect::<Vec<Pair>>()
        };
        if renewed.len() * on.len() <= FEW {
            let on = on.keys().copied().collect();
            return renewed.iter().flat_map(|&one| with(one, &on)).collect();
        }
        // The clusters on it that are beside each cluster elsewhere.
        let mut beside: BTreeMap<LinkId, BTreeSet<LinkId>> = BTreeMap::new();
        for &base in on.keys() {
            let elsewhere = self.connectors_of(base).filter(|other| *other != number);
            for &near in elsewhere.flat_map(|other| self.on[other].keys()) {
                beside.entry(near).or_default().insert(base);
            }
        }
        let pairs = beside.iter().flat_map(|(near, bases)| {
            let new = bases.intersection(renewed).flat_map(|&one| with(one, bases));
            // Beside each other by two connectors.
            let is_own = on.contains_key(near);
            let own = is_own.then(|| with(*near, bases)).into_iter().flatten();
            new.chain(own.filter(|(a, b)| renewed.contains(a) || renewed.contains(b)))
        });
        pairs.collect()
    }

    /// All connections, ordered by the bases of their clusters.
    pub(super) fn connections(&self, known: Known<'_>) -> Vec<Between> {
        let all = self.on.iter().flat_map(|on| {
            let pairs = on.keys().enumerate();
            pairs.flat_map(|(index, &a)| on.keys().skip(index + 1).map(move |&b| (a, b)))
        });
        let all: BTreeSet<Pair> = all.collect();
        let all = all.into_iter();
        all.flat_map(|pair| self.between(known, pair)).collect()
    }

    /// All rings of three connections, and of two that slide, ordered by the bases of their clusters.
    pub(super) fn rings(&self) -> impl Iterator<Item = &Block> {
        self.rings.values()
    }

    /// The connectors that a cluster is on.
    fn connectors_of(&self, base: LinkId) -> impl Iterator<Item = usize> + Clone + '_ {
        self.of_cluster.get(&base).into_iter().flatten().copied()
    }

    fn count_connectors(&self, base: LinkId) -> usize {
        self.of_cluster.get(&base).map_or(0, BTreeSet::len)
    }

    /// The connectors that both of a pair are on.
    fn common(&self, (a, b): Pair) -> Vec<usize> {
        let [few, many] = fewer(a, b, |base| self.count_connectors(base));
        let are_common = |number: &usize| self.on[*number].contains_key(&many);
        self.connectors_of(few).filter(are_common).collect()
    }

    /// The clusters that may be in a ring with a pair. Of the three connections of a ring no two are by one connector: a pair with a
    /// single one has both others elsewhere.
    fn candidates(&self, (a, b): Pair, common: &[usize]) -> Vec<LinkId> {
        let single = match *common {
            [] => return Vec::new(),
            [single] => Some(single),
            _ => None,
        };
        let elsewhere = |base| self.connectors_of(base).filter(move |&one| Some(one) != single);
        // The ground may be on very many.
        let count = |base| elsewhere(base).map(|number| self.on[number].len()).sum();
        let [few, many] = fewer(a, b, count);
        let thirds = elsewhere(few).flat_map(|number| self.on[number].keys().copied());
        let thirds: BTreeSet<LinkId> = thirds.filter(|third| *third != a && *third != b).collect();
        let is_beside = |third: &LinkId| {
            let [one, other] = fewer(*third, many, |base| self.count_connectors(base));
            elsewhere(one).any(|number| self.on[number].contains_key(&other))
        };
        thirds.into_iter().filter(is_beside).collect()
    }

    /// Finds the rings anew that a pair of clusters is in.
    fn find_rings(&mut self, known: Known<'_>, pair: Pair) {
        let (a, b) = pair;
        let common = self.common(pair);
        if common.len() > 1 || self.rings.contains_key(&[a, b, b]) {
            let found = self.between(known, pair).collect::<Vec<Between>>();
            let found = found.windows(2);
            let found = found.filter_map(|two| ring_of_two(two[0], two[1]));
            let found = found.into_iter().next();
            match found {
                Some(ring) => self.rings.insert([a, b, b], ring),
                None => self.rings.remove(&[a, b, b]),
            };
        }
        let mut thirds = self.thirds.get(&pair).cloned().unwrap_or_default();
        thirds.extend(self.candidates(pair, &common));
        for third in thirds {
            let bases = sorted([a, b, third]);
            let ring = self.ring_of_three(known, bases);
            self.set_ring(bases, ring);
        }
    }

    /// Notes the ring of these three clusters, or that there is none.
    fn set_ring(&mut self, bases: [LinkId; 3], ring: Option<Block>) {
        let [a, b, c] = bases;
        for (pair, third) in [((a, b), c), ((a, c), b), ((b, c), a)] {
            let thirds = self.thirds.entry(pair).or_default();
            if ring.is_some() {
                thirds.insert(third);
            } else {
                thirds.remove(&third);
            }
        }
        match ring {
            Some(ring) => self.rings.insert(bases, ring),
            None => self.rings.remove(&bases),
        };
    }

    fn ring_of_three(&self, known: Known<'_>, [low, middle, high]: [LinkId; 3]) -> Option<Block> {
        let far = self.between(known, (low, high)).next()?;
        let near: Vec<Between> = self.between(known, (low, middle)).collect();
        let across = self.between(known, (middle, high));
        let mut found = across.flat_map(|across| {
            let near = near.iter();
            near.filter_map(move |near| ring_of_three(*near, across, far))
        });
        found.next()
    }

    /// The connections of a pair of clusters, in the order of the connectors.
    fn between<'k>(&'k self, known: Known<'k>, pair: Pair) -> impl Iterator<Item = Between> + 'k {
        let common = self.common(pair).into_iter();
        common.filter_map(move |number| self.between_on(known, pair, number))
    }

    /// The connection that a connector makes between two clusters that are on it.
    fn between_on(&self, known: Known<'_>, (a, b): Pair, number: usize) -> Option<Between> {
        let on = &self.on[number];
        let base = |axis| known.clusters.base(known.model.axis(axis).link);
        let (connection, pin) = match self.connectors[number] {
            Connector::Pin(number_of_pin) => {
                let pin = &known.structure.pins[number_of_pin];
                let [a, b] = [on.get(&a)?, on.get(&b)?];
                // In the order in which they stand on the pin.
                let connector = self.connectors[number];
                let first = first_of(known, connector, [*a, *b])?;
                let [from, to] = if first == *a { [*a, *b] } else { [*b, *a] };
                let joint = named_on(known.model, known.clusters, pin, from, to);
                let connection = pivot(pin, from, to)?;
                (Connection { joint, ..connection }, Some(number_of_pin))
            }
            Connector::Slide(connection) => (connection, None),
        };
        let connection = if base(connection.from) == a { connection } else { connection.reverse() };
        let heading = known.structure.parallels.of(connection.joint);
        Some(Between { a, b, connection, pin, direction: heading.map(|heading| heading.number) })
    }
}

/// The one of two clusters of which there is less, and the other.
fn fewer(a: LinkId, b: LinkId, count: impl Fn(LinkId) -> usize) -> [LinkId; 2] {
    if count(a) <= count(b) { [a, b] } else { [b, a] }
}

fn sorted(mut bases: [LinkId; 3]) -> [LinkId; 3] {
    bases.sort_unstable();
    bases
}

/// The links that a connector is on.
fn links<'k>(
    model: &'k Model,
    structure: &'k Structure,
    connector: Connector,
) -> impl Iterator<Item = LinkId> + 'k {
    let (members, axes) = match connector {
        Connector::Pin(number) => (&structure.pins[number].members[..], None),
        Connector::Slide(connection) => (&[][..], Some([connection.from, connection.to])),
    };
    let slide = axes.into_iter().flatten();
    let slide = slide.map(|axis| model.axis(axis).link);
    members.iter().map(|member| member.0).chain(slide)
}

/// That of two links which is first on a connector.
fn first_of(known: Known<'_>, connector: Connector, pair: [LinkId; 2]) -> Option<LinkId> {
    links(known.model, known.structure, connector).find(|link| pair.contains(link))
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
    let found =
        found.or_else(|| pin.joints.iter().find(between)).or_else(|| pin.joints.iter().find(holds));
    found.copied().unwrap_or(pin.joints[0])
}
