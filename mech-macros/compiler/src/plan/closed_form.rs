//! The solutions of dyads by numbers: at compile time, to find every assembly.
//!
//! The program's formulas (`dyad.rs`) spare roots and round otherwise. With them offsets of gears at the start, which are often zero, would be
//! other roundings of zero, and programs would gain or lose additions.

use super::algebra::{Algebra, Numbers};
use super::dyad::{Dyad, Line};
use super::equation::{Equation, Solution};

/// Below this sine of the transmission angle a loop is taken to be at a dead point.
const DEAD: f64 = 1e-6;

/// Below this sine of the angle between them two guides are taken to be parallel: the better part of a rounding. What is above is
/// badly conditioned, but it is what was asked for.
const PARALLEL: f64 = 1e-14;

/// The solutions of a loop's equation.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum LoopSolutions {
    /// One or several, well apart.
    Found(Vec<Vec<Solution<f64>>>),
    /// The loop closes, but at a dead point.
    DeadPoint,
    /// The loop does not close; this much is missing, in scene units.
    Gap(f64),
}

type Vector = [f64; 2];

/// Solves a single ring of two unknowns; gives none for anything else.
pub(super) fn solve(equation: &Equation<f64>) -> Option<LoopSolutions> {
    match Dyad::of(&mut Numbers, equation)? {
        Dyad::TwoCircles { goal, arms } => Some(two_circles(goal, arms)),
        Dyad::CircleAndLine { goal, arm, along } => Some(circle_and_line(goal, arm, along)),
        Dyad::TurningLine { goal, arm, along } => Some(turning_line(goal, arm, along)),
        Dyad::TwoLines { goal, lines } => Some(two_lines(goal, lines)),
    }
}

/// The solutions on both sides, by the sign of a root of this square; `greatest` is the root at a transmission angle of 90°.
fn on_both_sides(
    square: f64,
    greatest: f64,
    solution: impl Fn(f64) -> [Solution<f64>; 2],
) -> LoopSolutions {
    let sine = square.max(0.0).sqrt() / greatest;
    if sine.is_nan() || sine < DEAD {
        return LoopSolutions::DeadPoint;
    }
    let root = square.sqrt();
    LoopSolutions::Found([root, -root].map(|root| solution(root).to_vec()).to_vec())
}

/// The unit vector that turns `from` into the direction of `to`.
fn between(from: Vector, to: Vector) -> Solution<f64> {
    let size = length(from) * length(to);
    let (along, across) = (Numbers.dot(from, to), Numbers.cross(from, to));
    Solution::Direction([along / size, across / size])
}

fn length(v: Vector) -> f64 {
    v[0].hypot(v[1])
}

/// u·a + v·b = goal.
fn two_circles(goal: Vector, [a, b]: [Vector; 2]) -> LoopSolutions {
    let (d, ra, rb) = (length(goal), length(a), length(b));
    let gap = (d - ra - rb).max((ra - rb).abs() - d);
    if gap > 1e-9 * (d + ra + rb) {
        return LoopSolutions::Gap(gap);
    }
    if d == 0.0 {
        return LoopSolutions::DeadPoint;
    }
    // Sixteen times the squared area of the triangle, in factors.
    let area = ((ra + rb) - d) * ((ra + rb) + d) * (d - (ra - rb)) * (d + (ra - rb));
    let along = (d * d + ra * ra - rb * rb) / (2.0 * d);
    on_both_sides(area, 2.0 * ra * rb, |root| {
        let tip = Numbers.rotate(goal.map(|part| part / d), [along, root / (2.0 * d)]);
        [between(a, tip), between(b, Numbers.minus(goal, tip))]
    })
}

/// u·arm + t·along = goal, `along` fixed.
fn circle_and_line(goal: Vector, arm: Vector, along: Vector) -> LoopSolutions {
    let radius = length(arm);
    let Line { foot, height, .. } = Line::new(&mut Numbers, goal, along);
    if height.abs() - radius > 1e-9 * (length(goal) + radius) {
        return LoopSolutions::Gap(height.abs() - radius);
    }
    let square = (radius - height) * (radius + height);
    on_both_sides(square, radius, |root| {
        let displacement = foot + root;
        let tip = Numbers.minus(goal, Numbers.scale(displacement, along));
        [between(arm, tip), Solution::Slide(displacement)]
    })
}

/// u·(arm + t·along) = goal: the line turns with the arm.
fn turning_line(goal: Vector, arm: Vector, along: Vector) -> LoopSolutions {
    let reach = length(goal);
    let Line { foot, height, .. } = Line::new(&mut Numbers, arm, along);
    if height.abs() - reach > 1e-9 * (length(arm) + reach) {
        return LoopSolutions::Gap(height.abs() - reach);
    }
    let square = (reach - height) * (reach + height);
    on_both_sides(square, reach, |root| {
        let displacement = root - foot;
        let tip = Numbers.plus(arm, Numbers.scale(displacement, along));
        [between(tip, goal), Solution::Slide(displacement)]
    })
}

/// s·a + t·b = goal.
fn two_lines(goal: Vector, [a, b]: [Vector; 2]) -> LoopSolutions {
    let det = Numbers.cross(a, b);
    if det.is_nan() || det.abs() < PARALLEL {
        return LoopSolutions::DeadPoint;
    }
    let [first, second] = [Numbers.cross(goal, b), Numbers.cross(a, goal)];
    let both = [first / det, second / det].map(Solution::Slide);
    LoopSolutions::Found(vec![both.to_vec()])
}
