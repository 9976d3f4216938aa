//! The order in which the equations of equilibrium are solved: which of them have to be solved together, and for which balances these are
//! few.
//!
//! Equations and unknowns are matched; what then depends on each other in a circle is one block (the fine decomposition of
//! Dulmage and Mendelsohn). About which point moments are taken and along which axes forces are summed is free for each link, and
//! decides how large the blocks are: a dyad takes four equations about the wrong points, and two about the right ones.

use petgraph::algo::tarjan_scc;
use petgraph::graph::{DiGraph, NodeIndex};
use std::collections::{BTreeMap, BTreeSet, HashSet};

/// The unknowns that each equation contains.
pub(super) type Pattern = Vec<Vec<usize>>;

/// Equations with as many unknowns, to be solved together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct EquationSet {
    pub(super) equations: Vec<usize>,
    pub(super) unknowns: Vec<usize>,
}

/// The number of times that the balances of all links are tried.
const PASSES: usize = 3;

/// Chooses one of several balances for the three equations of each link, so that as few as possible have to be solved
/// together. Gives the choices and the blocks, in the order in which they are solved; none if they do not determine the unknowns.
pub(super) fn choose_balances(
    alternatives: &[Vec<[Vec<usize>; 3]>],
    unknowns: usize,
) -> Option<(Vec<usize>, Vec<EquationSet>)> {
    let mut choices = vec![0; alternatives.len()];
    let first = alternatives.iter().flat_map(|alternatives| alternatives[0].clone());
    let mut system = System::new(first.collect(), unknowns)?;
    for _ in 0..PASSES {
        let mut is_better = false;
        for (link, alternatives) in alternatives.iter().enumerate() {
            for (other, balance) in alternatives.iter().enumerate() {
                if system.improve(3 * link, balance) {
                    (choices[link], is_better) = (other, true);
                }
            }
        }
        if !is_better {
            break;
        }
    }
    let blocks = blocks(&system.pattern, unknowns)?;
    Some((choices, blocks))
}

/// A square system with its equations matched to unknowns, and the sizes of its blocks. Where one link gets other equations, only what
/// these depend on is matched and counted anew.
struct System {
    pattern: Pattern,
    matching: Matching,
    /// For each equation the number of those in its block.
    sizes: Vec<usize>,
}

impl System {
    fn new(pattern: Pattern, unknowns: usize) -> Option<Self> {
        let matching = Matching::new(&pattern, unknowns)?;
        let blocks = components(&pattern, &matching, 0..pattern.len());
        let mut system = Self { sizes: vec![0; pattern.len()], pattern, matching };
        system.note_sizes(&blocks);
        Some(system)
    }

    /// Gives a link other equations, if these take less work.
    fn improve(&mut self, first: usize, balance: &[Vec<usize>; 3]) -> bool {
        let own = first..first + balance.len();
        let before: Pattern = self.pattern[own.clone()].to_vec();
        self.pattern[own.clone()].clone_from_slice(balance);
        let mut changes = Vec::new();
        for equation in own.clone() {
            self.matching.release(equation, &mut changes);
        }
        let mut equations = own.clone();
        let is_matched = equations.all(|equation| {
            let found = self.matching.augment(&self.pattern, equation);
            found.map(|found| changes.extend(found)).is_some()
        });
        if is_matched {
            let concerned = self.concerned(own.start, &before, &changes);
            let blocks = components(&self.pattern, &self.matching, concerned.iter().copied());
            // Each equation has its share in the cube of the size of its block.
            let old: usize = concerned.iter().map(|&one| self.sizes[one].pow(2)).sum();
            let new: usize = blocks.iter().map(|block| block.len().pow(3)).sum();
            if new < old {
                self.note_sizes(&blocks);
                return true;
            }
        }
        self.matching.undo(&changes);
        self.pattern[own].clone_from_slice(&before);
        false
    }

    fn note_sizes(&mut self, blocks: &[Vec<usize>]) {
        for block in blocks {
            for &equation in block {
                self.sizes[equation] = block.len();
            }
        }
    }

    /// The equations that those of a link, or those that are matched anew, depend on, before a change or after it: no block has some of
    /// these and others.
    fn concerned(&self, first: usize, before: &Pattern, changes: &[Change]) -> BTreeSet<usize> {
        let mut former: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for &Change { equation, unknown } in changes {
            former.entry(unknown).or_default().push(equation);
        }
        let own = first..first + before.len();
        let mut found: BTreeSet<usize> = own.chain(former.values().flatten().copied()).collect();
        let mut waiting: Vec<usize> = found.iter().copied().collect();
        while let Some(equation) = waiting.pop() {
            let old = equation.checked_sub(first).and_then(|own| before.get(own));
            for unknown in self.pattern[equation].iter().chain(old.into_iter().flatten()) {
                let owners = self.matching.equation_of[*unknown].iter();
                let owners = owners.chain(former.get(unknown).into_iter().flatten());
                for &owner in owners {
                    if found.insert(owner) {
                        waiting.push(owner);
                    }
                }
            }
        }
        found
    }
}

/// The blocks of a square system, in the order in which they are solved; none if it is not square or singular whatever its numbers.
fn blocks(pattern: &Pattern, unknowns: usize) -> Option<Vec<EquationSet>> {
    let matching = Matching::new(pattern, unknowns)?;
    let blocks = components(pattern, &matching, 0..pattern.len()).into_iter();
    let blocks = blocks.map(|mut equations| {
        equations.sort_unstable();
        let mut unknowns: Vec<usize> =
            equations.iter().filter_map(|&equation| matching.of_equation[equation]).collect();
        unknowns.sort_unstable();
        EquationSet { equations, unknowns }
    });
    Some(blocks.collect())
}

/// Which of these equations have to be solved together, in the order in which they are solved.
fn components(
    pattern: &Pattern,
    matching: &Matching,
    equations: impl Iterator<Item = usize> + Clone,
) -> Vec<Vec<usize>> {
    let mut graph = DiGraph::<usize, ()>::new();
    let nodes: BTreeMap<usize, NodeIndex> =
        equations.clone().map(|equation| (equation, graph.add_node(equation))).collect();
    for equation in equations {
        for &unknown in &pattern[equation] {
            let needed = matching.equation_of[unknown];
            let needed = needed.filter(|needed| *needed != equation);
            if let Some(needed) = needed.and_then(|needed| nodes.get(&needed)) {
                graph.add_edge(nodes[&equation], *needed, ());
            }
        }
    }
    let components = tarjan_scc(&graph).into_iter();
    let equations = |component: Vec<NodeIndex>| component.into_iter().map(|node| graph[node]);
    components.map(|component| equations(component).collect()).collect()
}

/// An equation had this unknown before.
struct Change {
    equation: usize,
    unknown: usize,
}

/// Equations and unknowns, each matched to one of the others, by augmenting paths.
struct Matching {
    of_equation: Vec<Option<usize>>,
    equation_of: Vec<Option<usize>>,
}

impl Matching {
    /// An unknown for each equation, and all unknowns; none if that cannot be.
    fn new(pattern: &Pattern, unknowns: usize) -> Option<Self> {
        if pattern.len() != unknowns {
            return None;
        }
        let mut matching =
            Self { of_equation: vec![None; pattern.len()], equation_of: vec![None; unknowns] };
        let mut equations = 0..pattern.len();
        let is_whole = equations.all(|equation| matching.augment(pattern, equation).is_some());
        is_whole.then_some(matching)
    }

    /// Takes an equation its unknown.
    fn release(&mut self, equation: usize, changes: &mut Vec<Change>) {
        if let Some(unknown) = self.of_equation[equation].take() {
            self.equation_of[unknown] = None;
            changes.push(Change { equation, unknown });
        }
    }

    /// Finds an unknown for an equation, perhaps by giving others another one; gives what these had before.
    fn augment(&mut self, pattern: &Pattern, equation: usize) -> Option<Vec<Change>> {
        let mut seen = HashSet::new();
        // The equations on the way, each with the number of its unknowns that were looked at.
        let mut way = vec![(equation, 0)];
        while let Some((equation, looked)) = way.last_mut() {
            let Some(&unknown) = pattern[*equation].get(*looked) else {
                way.pop();
                continue;
            };
            *looked += 1;
            if !seen.insert(unknown) {
                continue;
            }
            if let Some(other) = self.equation_of[unknown] {
                way.push((other, 0));
                continue;
            }
            let mut changes = Vec::new();
            for (equation, looked) in way {
                let unknown = pattern[equation][looked - 1];
                let former = self.of_equation[equation].replace(unknown);
                changes.extend(former.map(|unknown| Change { equation, unknown }));
                self.equation_of[unknown] = Some(equation);
            }
            return Some(changes);
        }
        None
    }

    /// Gives equations back what they had before all of these changes.
    fn undo(&mut self, changes: &[Change]) {
        for Change { equation, .. } in changes {
            if let Some(unknown) = self.of_equation[*equation].take() {
                self.equation_of[unknown] = None;
            }
        }
        // The first that an equation had comes last.
        for Change { equation, unknown } in changes.iter().rev() {
            self.of_equation[*equation] = Some(*unknown);
        }
        for Change { equation, .. } in changes {
            if let Some(unknown) = self.of_equation[*equation] {
                self.equation_of[unknown] = Some(*equation);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Pattern, System, blocks};
    use proptest::collection::vec;
    use proptest::strategy::{Strategy, ValueTree};
    use proptest::test_runner::TestRunner;

    fn draw<S: Strategy>(runner: &mut TestRunner, strategy: S) -> S::Value {
        strategy.new_tree(runner).expect("a value").current()
    }

    fn equation(unknowns: usize) -> impl Strategy<Value = Vec<usize>> {
        vec(0..unknowns, 1..4)
    }

    fn work(pattern: &Pattern) -> Option<usize> {
        let blocks = blocks(pattern, pattern.len())?;
        Some(blocks.iter().map(|block| block.equations.len().pow(3)).sum())
    }

    #[test]
    fn other_equations_are_taken_where_the_whole_takes_less_work() {
        let mut runner = TestRunner::deterministic();
        let (mut taken, mut kept) = (0, 0);
        while taken < 500 || kept < 500 {
            let unknowns = 3 * draw(&mut runner, 2..7_usize);
            let pattern: Pattern = (0..unknowns)
                .map(|own| [vec![own], draw(&mut runner, equation(unknowns))].concat())
                .collect();
            let mut system =
                System::new(pattern, unknowns).expect("each equation has its own unknown");
            for _ in 0..10 {
                let first = 3 * draw(&mut runner, 0..unknowns / 3);
                let balance = [(); 3].map(|()| draw(&mut runner, equation(unknowns)));
                let mut tried = system.pattern.clone();
                tried[first..first + 3].clone_from_slice(&balance);
                let (old, new) = (work(&system.pattern), work(&tried));
                let is_less = new.is_some_and(|new| Some(new) < old);
                let before = system.pattern.clone();
                assert_eq!(
                    system.improve(first, &balance),
                    is_less,
                    "{before:?} {first} {balance:?}"
                );
                assert_eq!(system.pattern, if is_less { tried } else { before });
                let sizes: usize = system.sizes.iter().map(|size| size.pow(2)).sum();
                assert_eq!(Some(sizes), work(&system.pattern));
                *if is_less { &mut taken } else { &mut kept } += 1;
            }
        }
    }
}
