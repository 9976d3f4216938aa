//! Which clusters hold each other: the smallest sets of clusters whose relative positions follow from what joins these clusters
//! alone. Two such sets share one cluster at most, so what is solved together does not depend on the order of declaration.
//!
//! They are found by counting (a pebble game). A cluster has two freedoms and an angle, which it shares with those that it slides on; a
//! pin has two. An equation takes a freedom from one of the parts it speaks of: a loop of slides has two, and not three. A set holds
//! itself where no more than three freedoms are left to it: those of a body.

use super::between::Between;
use crate::model::LinkId;
use petgraph::unionfind::UnionFind;

/// The freedoms of a body in the plane.
const BODY: usize = 3;
/// The freedoms of a place: of a pin, or of a cluster but for its angle.
const PLACE: usize = 2;
/// The freedom of an angle.
const ANGLE: usize = 1;

/// The smallest sets of clusters that hold each other, the smallest first. `rolls` are the clusters of each gear, belt or rack.
pub(super) fn sets(connections: &[Between], rolls: &[Vec<LinkId>]) -> Vec<Vec<LinkId>> {
    let parts = Parts::of(connections);
    let clusters = &parts.clusters;
    let mut count = count_freedoms(connections, rolls, &parts);
    let mut found: Vec<Vec<LinkId>> = Vec::new();
    for between in connections {
        if let Some(parts) = count.smallest_set(parts.of_clusters([between.a, between.b])) {
            // Among the parts are angles and pins, too, after all clusters.
            let bases = parts.into_iter().filter_map(|part| clusters.get(part));
            found.push(bases.copied().collect());
        }
    }
    found.sort_by(|a, b| (a.len(), a).cmp(&(b.len(), b)));
    let mut smallest: Vec<Vec<LinkId>> = Vec::new();
    for set in found {
        let within = |known: &Vec<LinkId>| known.iter().all(|base| set.contains(base));
        if !smallest.iter().any(within) {
            smallest.push(set);
        }
    }
    smallest
}

/// The parts that have freedoms: the places of clusters, then angles, then pins.
struct Parts {
    clusters: Vec<LinkId>,
    /// For each cluster the part that is its angle.
    angles: Vec<usize>,
}

impl Parts {
    fn of(connections: &[Between]) -> Self {
        let ends = connections.iter().flat_map(|between| [between.a, between.b]);
        let mut clusters: Vec<LinkId> = ends.collect();
        clusters.sort_unstable();
        clusters.dedup();
        let mut classes = UnionFind::<usize>::new(clusters.len());
        for between in connections.iter().filter(|between| between.connection.slides()) {
            let [a, b] = [between.a, between.b].map(|base| clusters.binary_search(&base));
            if let (Ok(a), Ok(b)) = (a, b) {
                classes.union(a, b);
            }
        }
        let angles = (0..clusters.len()).map(|cluster| clusters.len() + classes.find(cluster));
        Self { angles: angles.collect(), clusters }
    }

    /// The parts of these clusters, each once.
    fn of_clusters(&self, bases: impl IntoIterator<Item = LinkId>) -> Vec<usize> {
        let places = bases.into_iter();
        let places = places.filter_map(|base| self.clusters.binary_search(&base).ok());
        let parts = places.flat_map(|place| [place, self.angles[place]]);
        let mut parts: Vec<usize> = parts.collect();
        parts.sort_unstable();
        parts.dedup();
        parts
    }

    /// The parts of a cluster and a pin.
    fn of_pinned(&self, base: LinkId, pin: usize) -> Vec<usize> {
        let mut parts = self.of_clusters([base]);
        parts.push(2 * self.clusters.len() + pin);
        parts
    }

    /// For each part its freedoms, where there are so many pins.
    fn freedoms(&self, pins: usize) -> Vec<usize> {
        let clusters = self.clusters.len();
        [vec![PLACE; clusters], vec![ANGLE; clusters], vec![PLACE; pins]].concat()
    }
}

/// Counts the freedoms that the connections take.
fn count_freedoms(connections: &[Between], rolls: &[Vec<LinkId>], parts: &Parts) -> Count {
    let mut equations: Vec<Vec<usize>> = Vec::new();
    let mut pinned: Vec<(usize, LinkId)> = Vec::new();
    for between in connections {
        let ends = [between.a, between.b];
        match between.pin {
            Some(pin) => pinned.extend(ends.map(|base| (pin, base))),
            // That it keeps an angle is counted already.
            None => equations.push(parts.of_clusters(ends)),
        }
    }
    pinned.sort_unstable();
    pinned.dedup();
    let mut pins: Vec<usize> = pinned.iter().map(|(pin, _)| *pin).collect();
    pins.dedup();
    for (pin, base) in pinned {
        if let Ok(pin) = pins.binary_search(&pin) {
            let ends = parts.of_pinned(base, pin);
            equations.extend([ends.clone(), ends]);
        }
    }
    for roll in rolls {
        let ends = parts.of_clusters(roll.iter().copied());
        if roll.len() > 1 && !ends.is_empty() {
            equations.push(ends);
        }
    }
    Count::new(parts.freedoms(pins.len()), equations)
}

/// The freedoms that equations have taken.
struct Count {
    /// For each part the freedoms that are left to it.
    free: Vec<usize>,
    /// For each equation the parts it speaks of.
    equations: Vec<Vec<usize>>,
    /// For each part the equations that have taken a freedom from it.
    taken: Vec<Vec<usize>>,
}

impl Count {
    fn new(free: Vec<usize>, equations: Vec<Vec<usize>>) -> Self {
        let mut count = Self { taken: vec![Vec::new(); free.len()], free, equations };
        for equation in 0..count.equations.len() {
            let ends = count.equations[equation].clone();
            // An equation that follows from those before takes no freedom.
            if count.gather(&ends, BODY + 1)
                && let Some(&end) = ends.iter().find(|&&end| count.free[end] > 0)
            {
                count.free[end] -= 1;
                count.taken[end].push(equation);
            }
        }
        count
    }

    /// The smallest set of parts that holds these, if one does.
    fn smallest_set(&mut self, mut set: Vec<usize>) -> Option<Vec<usize>> {
        if self.gather(&set, BODY + 1) {
            return None;
        }
        let mut next = 0;
        while let Some(&part) = set.get(next) {
            for &equation in &self.taken[part] {
                for &other in &self.equations[equation] {
                    if !set.contains(&other) {
                        set.push(other);
                    }
                }
            }
            next += 1;
        }
        set.sort_unstable();
        Some(set)
    }

    /// Moves free freedoms to these parts until they have as many as are wanted; whether that can be done.
    fn gather(&mut self, ends: &[usize], wanted: usize) -> bool {
        while ends.iter().map(|&end| self.free[end]).sum::<usize>() < wanted {
            let mut seen = vec![false; self.free.len()];
            for &end in ends {
                seen[end] = true;
            }
            if !ends.iter().any(|&end| self.free_one(end, &mut seen)) {
                return false;
            }
        }
        true
    }

    /// Frees one freedom of a part: an equation takes one from another part instead.
    fn free_one(&mut self, to: usize, seen: &mut [bool]) -> bool {
        for index in 0..self.taken[to].len() {
            let equation = self.taken[to][index];
            for end in 0..self.equations[equation].len() {
                let other = self.equations[equation][end];
                if std::mem::replace(&mut seen[other], true) {
                    continue;
                }
                if self.free[other] > 0 || self.free_one(other, seen) {
                    self.free[other] -= 1;
                    self.free[to] += 1;
                    self.taken[to].swap_remove(index);
                    self.taken[other].push(equation);
                    return true;
                }
            }
        }
        false
    }
}
