//! Which clusters hold each other: the smallest sets of clusters whose relative positions follow from what joins these clusters
//! alone. Two such sets share one cluster at most, so what is solved together does not depend on the order of declaration.
//!
//! They are found by counting (a pebble game). A cluster has three freedoms, a pin two. An equation takes a freedom from one of
//! the parts it speaks of. A set holds itself where no more than three freedoms are left to it: those of a body.

use super::between::Between;
use crate::model::LinkId;

/// The freedoms of a body in the plane.
const BODY: usize = 3;
/// The freedoms of a pin.
const PIN: usize = 2;

/// The smallest sets of clusters that hold each other, the smallest first. `rolls` are the clusters of each gear, belt or rack.
pub(super) fn sets(connections: &[Between], rolls: &[Vec<LinkId>]) -> Vec<Vec<LinkId>> {
    let (clusters, mut count) = count_freedoms(connections, rolls);
    let place = |base| clusters.binary_search(&base).ok();
    let mut found: Vec<Vec<LinkId>> = Vec::new();
    for between in connections {
        if let (Some(a), Some(b)) = (place(between.a), place(between.b))
            && let Some(parts) = count.smallest_set([a, b])
        {
            // Among the parts are pins, too, after all clusters.
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

/// The clusters in order, and the count of their freedoms. Pins come after all clusters.
fn count_freedoms(connections: &[Between], rolls: &[Vec<LinkId>]) -> (Vec<LinkId>, Count) {
    let mut clusters: Vec<LinkId> = connections
        .iter()
        .flat_map(|between| [between.a, between.b])
        .collect();
    clusters.sort_unstable();
    clusters.dedup();
    let place = |base: LinkId| clusters.binary_search(&base).ok();
    let mut equations: Vec<Vec<usize>> = Vec::new();
    let mut pinned: Vec<(usize, LinkId)> = Vec::new();
    for between in connections {
        if let Some(pin) = between.pin {
            pinned.extend([(pin, between.a), (pin, between.b)]);
        } else {
            let ends = [between.a, between.b].into_iter().filter_map(place);
            let ends: Vec<usize> = ends.collect();
            equations.extend([ends.clone(), ends]);
        }
    }
    pinned.sort_unstable();
    pinned.dedup();
    let mut pins: Vec<usize> = pinned.iter().map(|(pin, _)| *pin).collect();
    pins.dedup();
    for (pin, base) in pinned {
        if let (Ok(pin), Some(cluster)) = (pins.binary_search(&pin), place(base)) {
            let ends = vec![cluster, clusters.len() + pin];
            equations.extend([ends.clone(), ends]);
        }
    }
    for roll in rolls {
        let ends: Vec<usize> = roll.iter().copied().filter_map(place).collect();
        if ends.len() > 1 {
            equations.push(ends);
        }
    }
    let free = [vec![BODY; clusters.len()], vec![PIN; pins.len()]].concat();
    let count = Count::new(free, equations);
    (clusters, count)
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
        let mut count = Self {
            taken: vec![Vec::new(); free.len()],
            free,
            equations,
        };
        for equation in 0..count.equations.len() {
            let ends = count.equations[equation].clone();
            // What follows from the equations before takes nothing.
            if count.gather(&ends, BODY + 1)
                && let Some(&end) = ends.iter().find(|&&end| count.free[end] > 0)
            {
                count.free[end] -= 1;
                count.taken[end].push(equation);
            }
        }
        count
    }

    /// The smallest set of parts that holds these two, if one does.
    fn smallest_set(&mut self, pair: [usize; 2]) -> Option<Vec<usize>> {
        if self.gather(&pair, BODY + 1) {
            return None;
        }
        let mut set = pair.to_vec();
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

    /// Brings so many free freedoms to these parts, if that can be done.
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
