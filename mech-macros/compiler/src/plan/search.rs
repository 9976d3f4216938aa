//! The solutions of coupled loops, by numbers: Newton's iteration from many starts, at compile time.

use super::algebra::Numbers;
use super::closed_form::LoopSolutions;
use super::equation::Equation;
use super::unknown::{Solution, Unknown};
use nalgebra::{DMatrix, DVector};

/// Starts for each unknown: enough to find, in practice, all of the up to six assemblies of a triad.
const STARTS: usize = 60;
/// Newton's iteration converges in fewer rounds than this or not at all.
const ROUNDS: usize = 60;
/// Loops are closed where this part of the mechanism's size is missing at most.
const CLOSED: f64 = 1e-13;
/// Assemblies closer than this are one.
const APART: f64 = 1e-5;

/// Redundant joints may be open by this part of the mechanism's size: what was solved before them is known no better where it is badly
/// conditioned.
const MATCH: f64 = 1e-9;
/// An iteration has settled when its step is below this.
const SETTLED: f64 = 1e-12;

/// Solves any equation: from the directions that are wanted, and where these leave something open from many starts.
pub(super) fn search(
    equation: &Equation<f64>,
    wanted: &[Option<[f64; 2]>],
    size: f64,
) -> LoopSolutions {
    let open = wanted.iter().any(Option::is_none);
    // Rolling ties turns, not places: where it takes unknowns away, the start is free, and what is nearest to what is wanted is meant.
    let free = equation.unknowns.len() > 2 * equation.rings.len();
    let starts = if !open || free { 1 } else { STARTS * equation.unknowns.len() };
    let mut sequence = Halton::default();
    let mut solutions: Vec<Vec<Solution<f64>>> = Vec::new();
    let (mut least, mut dead) = (f64::INFINITY, false);
    for start in 0..starts {
        let mut now: Vec<Solution<f64>> = Vec::new();
        for (axis, unknown) in equation.unknowns.iter().enumerate() {
            let at = if start == 0 { 0.0 } else { sequence.at(axis) };
            now.push(match (unknown, wanted[axis]) {
                (Unknown::Direction(_), Some(direction)) => Solution::Direction(direction),
                (Unknown::Direction(_), None) => {
                    let (sin, cos) = (std::f64::consts::TAU * at).sin_cos();
                    Solution::Direction([cos, sin])
                }
                (Unknown::Slide(_), _) => {
                    Solution::Slide(4.0 * size * (at - if start == 0 { 0.0 } else { 0.5 }))
                }
            });
        }
        sequence.advance();
        let is_known = |found: &[Solution<f64>]| {
            let mut known = solutions.iter();
            known.any(|known| !differ(known, found, size))
        };
        let scouted = if start == 0 { None } else { scout(equation, &now, size) };
        let result = match scouted {
            Some(NewtonResult::Solution(found)) if !is_known(&found) => newton(equation, now, size),
            Some(result) => result,
            None => newton(equation, now, size),
        };
        match result {
            NewtonResult::Solution(solution) if is_known(&solution) => {}
            NewtonResult::Solution(solution) => solutions.push(solution),
            NewtonResult::Singular => dead = true,
            NewtonResult::Nothing(gap) => least = least.min(gap),
        }
    }
    match (solutions.is_empty(), dead) {
        (false, _) => LoopSolutions::Found(solutions),
        (true, true) => LoopSolutions::DeadPoint,
        (true, false) => LoopSolutions::Gap(least),
    }
}

enum NewtonResult {
    Solution(Vec<Solution<f64>>),
    /// It closes where its equations are singular.
    Singular,
    /// It does not close; this much was missing at last.
    Nothing(f64),
}

/// The equations at a place: what is missing in each, and how it changes with each unknown.
struct Linear {
    gap: DVector<f64>,
    matrix: DMatrix<f64>,
}

impl Linear {
    fn at(now: &[Solution<f64>], equation: &Equation<f64>) -> Self {
        let residuals = equation.residuals(&mut Numbers, now);
        let gap = DVector::from_iterator(
            2 * residuals.rings.len(),
            residuals.rings.iter().flat_map(|ring| ring.gap),
        );
        let matrix = DMatrix::from_fn(gap.len(), now.len(), |row, column| {
            residuals.rings[row / 2].columns[column][row % 2]
        });
        Self { gap, matrix }
    }
}

/// Follows a start by elimination, which takes a tenth of the time: most starts lead to nothing, or to what is known. `None` where only
/// singular values tell.
fn scout(equation: &Equation<f64>, start: &[Solution<f64>], size: f64) -> Option<NewtonResult> {
    let mut now = start.to_vec();
    let mut missing = f64::INFINITY;
    for _ in 0..ROUNDS {
        let Linear { gap, matrix } = Linear::at(&now, equation);
        missing = gap.amax();
        if !matrix.is_square() {
            return None;
        }
        if missing <= CLOSED * size {
            let values = matrix.singular_values();
            return Some(if is_singular(&values) {
                NewtonResult::Singular
            } else {
                NewtonResult::Solution(now)
            });
        }
        let step = matrix.lu().solve(&-gap)?;
        if step.iter().any(|value| !value.is_finite()) {
            return None;
        }
        advance(&mut now, &step, size);
    }
    Some(NewtonResult::Nothing(missing))
}

fn newton(equation: &Equation<f64>, mut now: Vec<Solution<f64>>, size: f64) -> NewtonResult {
    let mut missing = f64::INFINITY;
    for _ in 0..ROUNDS {
        let Linear { gap, matrix } = Linear::at(&now, equation);
        missing = gap.amax();
        // Square or, where joints are redundant, as good as possible.
        let is_redundant = gap.len() > now.len();
        let singular = matrix.svd(true, true);
        let step = singular.solve(&-gap, 1e-12 * singular.singular_values.max());
        let is_settled = |step: &DVector<f64>| {
            is_redundant && missing <= MATCH * size && step.amax() <= SETTLED * size.max(1.0)
        };
        if missing <= CLOSED * size || step.as_ref().is_ok_and(is_settled) {
            return if is_singular(&singular.singular_values) {
                NewtonResult::Singular
            } else {
                NewtonResult::Solution(now)
            };
        }
        let Ok(step) = step else {
            return NewtonResult::Nothing(missing);
        };
        if step.iter().any(|value| !value.is_finite()) {
            return NewtonResult::Nothing(missing);
        }
        advance(&mut now, &step, size);
    }
    NewtonResult::Nothing(missing)
}

/// Whether equations with these singular values leave a direction open.
fn is_singular(values: &DVector<f64>) -> bool {
    values.min() <= 1e-7 * values.max()
}

/// Makes a step, but none that leads astray: at most a radian, and the mechanism's size.
fn advance(now: &mut [Solution<f64>], step: &DVector<f64>, size: f64) {
    for (unknown, step) in now.iter_mut().zip(step.iter()) {
        match unknown {
            Solution::Direction([cos, sin]) => {
                let (s, c) = step.clamp(-1.0, 1.0).sin_cos();
                (*cos, *sin) = (*cos * c - *sin * s, *sin * c + *cos * s);
                let length = cos.hypot(*sin);
                (*cos, *sin) = (*cos / length, *sin / length);
            }
            Solution::Slide(displacement) => *displacement += step.clamp(-size, size),
        }
    }
}

/// Whether two solutions differ.
fn differ(a: &[Solution<f64>], b: &[Solution<f64>], size: f64) -> bool {
    a.iter().zip(b).any(|pair| match pair {
        (Solution::Direction(a), Solution::Direction(b)) => {
            (a[0] - b[0]).hypot(a[1] - b[1]) > APART
        }
        (Solution::Slide(a), Solution::Slide(b)) => (a - b).abs() > APART * size,
        _ => true,
    })
}

/// Halton's sequence of points in a unit box: the same in every build.
#[derive(Debug, Default)]
pub(crate) struct Halton(u32);

impl Halton {
    /// A coordinate of the present point, from 0 to 1.
    pub(crate) fn at(&self, axis: usize) -> f64 {
        const PRIMES: [u32; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
        let base = PRIMES[axis % PRIMES.len()];
        let (mut index, mut part, mut sum) = (self.0 + 1, 1.0, 0.0);
        while index > 0 {
            part /= f64::from(base);
            sum += part * f64::from(index % base);
            index /= base;
        }
        sum
    }

    /// Goes on to the next point.
    pub(crate) fn advance(&mut self) {
        self.0 += 1;
    }
}
