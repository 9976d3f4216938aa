//! The order in which the equations of equilibrium are solved: which of them have to be solved together, and for which balances these are
//! few.
//!
//! Equations and unknowns are matched; what then depends on each other in a circle is one block (the fine decomposition of
//! Dulmage and Mendelsohn). About which point moments are taken and along which axes forces are summed is free for each link, and
//! decides how large the blocks are: a dyad takes four equations about the wrong points, and two about the right ones.

use petgraph::algo::tarjan_scc;
use petgraph::graph::{DiGraph, NodeIndex};

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
    let pattern = |choices: &[usize]| -> Pattern {
        let chosen = alternatives.iter().zip(choices);
        chosen
            .flat_map(|(alternatives, &choice)| alternatives[choice].clone())
            .collect()
    };
    let mut best = blocks(&pattern(&choices), unknowns)?;
    for _ in 0..PASSES {
        let before = work(&best);
        for link in 0..alternatives.len() {
            for other in 0..alternatives[link].len() {
                let mut tried = choices.clone();
                tried[link] = other;
                if let Some(found) = blocks(&pattern(&tried), unknowns)
                    && work(&found) < work(&best)
                {
                    (choices, best) = (tried, found);
                }
            }
        }
        if work(&best) == before {
            break;
        }
    }
    Some((choices, best))
}

/// The work of solving these: the sum of the cubes of their sizes.
fn work(blocks: &[EquationSet]) -> usize {
    blocks
        .iter()
        .map(|block| block.equations.len().pow(3))
        .sum()
}

/// The blocks of a square system, in the order in which they are solved; none if it is not square or singular whatever its numbers.
fn blocks(pattern: &Pattern, unknowns: usize) -> Option<Vec<EquationSet>> {
    if pattern.len() != unknowns {
        return None;
    }
    let of_equation = matching(pattern, unknowns)?;
    let mut equation_of = vec![0; unknowns];
    for (equation, &unknown) in of_equation.iter().enumerate() {
        equation_of[unknown] = equation;
    }
    let mut graph = DiGraph::<(), ()>::new();
    let nodes: Vec<NodeIndex> = pattern.iter().map(|_| graph.add_node(())).collect();
    for (equation, contained) in pattern.iter().enumerate() {
        for &unknown in contained {
            let needed = equation_of[unknown];
            if needed != equation {
                graph.add_edge(nodes[equation], nodes[needed], ());
            }
        }
    }
    let components = tarjan_scc(&graph).into_iter().map(|component| {
        let mut equations: Vec<usize> = component.into_iter().map(NodeIndex::index).collect();
        equations.sort_unstable();
        let mut unknowns: Vec<usize> = equations
            .iter()
            .map(|&equation| of_equation[equation])
            .collect();
        unknowns.sort_unstable();
        EquationSet {
            equations,
            unknowns,
        }
    });
    Some(components.collect())
}

/// An unknown for each equation, each once, by augmenting paths.
fn matching(pattern: &Pattern, unknowns: usize) -> Option<Vec<usize>> {
    let mut equation_of: Vec<Option<usize>> = vec![None; unknowns];
    for equation in 0..pattern.len() {
        let mut seen = vec![false; unknowns];
        if !augment(pattern, equation, &mut seen, &mut equation_of) {
            return None;
        }
    }
    let mut of_equation = vec![0; pattern.len()];
    for (unknown, equation) in equation_of.into_iter().enumerate() {
        of_equation[equation?] = unknown;
    }
    Some(of_equation)
}

/// Finds an unknown for an equation, perhaps by giving another equation another one.
fn augment(
    pattern: &Pattern,
    equation: usize,
    seen: &mut [bool],
    equation_of: &mut [Option<usize>],
) -> bool {
    for &unknown in &pattern[equation] {
        if std::mem::replace(&mut seen[unknown], true) {
            continue;
        }
        let free = match equation_of[unknown] {
            None => true,
            Some(other) => augment(pattern, other, seen, equation_of),
        };
        if free {
            equation_of[unknown] = Some(equation);
            return true;
        }
    }
    false
}
