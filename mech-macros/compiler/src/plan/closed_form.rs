//! The solutions of a loop's equation in closed form, by numbers: at compile time, to find every assembly.

use super::equation::{Equation, Solution, Unknown};

/// Below this sine of the transmission angle a loop is taken to be at a dead point.
const DEAD: f64 = 1e-6;

/// Below this sine of the angle between them two guides are taken to be parallel: the better part of a rounding. What is above is
/// badly conditioned, but it is what was asked for.
const PARALLEL: f64 = 1e-14;

/// The ways in which a loop can be closed.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Closure {
    /// One or several, well apart.
    Solutions(Vec<Vec<Solution<f64>>>),
    /// It closes, but at a dead point.
    Dead,
    /// It does not close; this much is missing.
    Gap(f64),
}

type Vector = [f64; 2];

/// Solves a single ring of two unknowns; gives none for anything else.
pub(super) fn close(equation: &Equation<f64>) -> Option<Closure> {
    let ([ring], [first, second]) = (&equation.rings[..], &equation.unknowns[..]) else {
        return None;
    };
    let goal = [-ring.offset[0], -ring.offset[1]];
    let arm = |unknown: usize| ring.arms[unknown];
    let slide = |unknown: usize| ring.slides.iter().find(|slide| slide.unknown == unknown);
    match (first, second) {
        (Unknown::Direction(_), Unknown::Direction(_)) => {
            Some(two_directions(goal, arm(0)?, arm(1)?))
        }
        (Unknown::Direction(_), Unknown::Slide(_)) => {
            let slide = slide(1)?;
            Some(match slide.turned_by {
                None => guided_arm(goal, arm(0)?, slide.along),
                Some(_) => sleeve(goal, arm(0)?, slide.along),
            })
        }
        (Unknown::Slide(_), Unknown::Slide(_)) => {
            Some(two_slides(goal, slide(0)?.along, slide(1)?.along))
        }
        // Directions come first.
        (Unknown::Slide(_), Unknown::Direction(_)) => None,
    }
}

fn length(v: Vector) -> f64 {
    v[0].hypot(v[1])
}

fn turned(by: Vector, v: Vector) -> Vector {
    [by[0] * v[0] - by[1] * v[1], by[1] * v[0] + by[0] * v[1]]
}

/// The unit vector that turns `from` into the direction of `to`.
fn between(from: Vector, to: Vector) -> Vector {
    let size = length(from) * length(to);
    [
        (from[0] * to[0] + from[1] * to[1]) / size,
        (from[0] * to[1] - from[1] * to[0]) / size,
    ]
}

/// u·a + v·b = goal: two circles.
fn two_directions(goal: Vector, a: Vector, b: Vector) -> Closure {
    let (d, ra, rb) = (length(goal), length(a), length(b));
    let gap = (d - ra - rb).max((ra - rb).abs() - d);
    if gap > 1e-9 * (d + ra + rb) {
        return Closure::Gap(gap);
    }
    // Sixteen times the squared area of the triangle, in factors.
    let area = ((ra + rb) - d) * ((ra + rb) + d) * (d - (ra - rb)) * (d + (ra - rb));
    let sine = area.max(0.0).sqrt() / (2.0 * ra * rb);
    if sine.is_nan() || sine < DEAD || d == 0.0 {
        return Closure::Dead;
    }
    let along = (d * d + ra * ra - rb * rb) / (2.0 * d);
    let across = area.sqrt() / (2.0 * d);
    let solutions = [1.0, -1.0].map(|side| {
        let unit = [goal[0] / d, goal[1] / d];
        let tip = turned(unit, [along, side * across]);
        let rest = [goal[0] - tip[0], goal[1] - tip[1]];
        [
            Solution::Direction(between(a, tip)),
            Solution::Direction(between(b, rest)),
        ]
    });
    Closure::Solutions(solutions.map(Vec::from).to_vec())
}

/// u·arm + t·along = goal, `along` fixed: a circle and a line.
fn guided_arm(goal: Vector, arm: Vector, along: Vector) -> Closure {
    let radius = length(arm);
    let foot = goal[0] * along[0] + goal[1] * along[1];
    let height = goal[1] * along[0] - goal[0] * along[1];
    if height.abs() - radius > 1e-9 * (length(goal) + radius) {
        return Closure::Gap(height.abs() - radius);
    }
    let square = (radius - height) * (radius + height);
    let sine = square.max(0.0).sqrt() / radius;
    if sine.is_nan() || sine < DEAD {
        return Closure::Dead;
    }
    let solutions = [1.0, -1.0].map(|side| {
        let displacement = foot + side * square.sqrt();
        let tip = [
            goal[0] - displacement * along[0],
            goal[1] - displacement * along[1],
        ];
        [
            Solution::Direction(between(arm, tip)),
            Solution::Slide(displacement),
        ]
    });
    Closure::Solutions(solutions.map(Vec::from).to_vec())
}

/// u·(arm + t·along) = goal: the line turns with the arm.
fn sleeve(goal: Vector, arm: Vector, along: Vector) -> Closure {
    let reach = length(goal);
    let foot = arm[0] * along[0] + arm[1] * along[1];
    let height = arm[1] * along[0] - arm[0] * along[1];
    if height.abs() - reach > 1e-9 * (length(arm) + reach) {
        return Closure::Gap(height.abs() - reach);
    }
    let square = (reach - height) * (reach + height);
    let sine = square.max(0.0).sqrt() / reach;
    if sine.is_nan() || sine < DEAD {
        return Closure::Dead;
    }
    let solutions = [1.0, -1.0].map(|side| {
        let displacement = side * square.sqrt() - foot;
        let tip = [
            arm[0] + displacement * along[0],
            arm[1] + displacement * along[1],
        ];
        [
            Solution::Direction(between(tip, goal)),
            Solution::Slide(displacement),
        ]
    });
    Closure::Solutions(solutions.map(Vec::from).to_vec())
}

/// s·a + t·b = goal.
fn two_slides(goal: Vector, a: Vector, b: Vector) -> Closure {
    let det = a[0] * b[1] - a[1] * b[0];
    if det.is_nan() || det.abs() < PARALLEL {
        return Closure::Dead;
    }
    let first = (goal[0] * b[1] - goal[1] * b[0]) / det;
    let second = (a[0] * goal[1] - a[1] * goal[0]) / det;
    Closure::Solutions(vec![vec![Solution::Slide(first), Solution::Slide(second)]])
}
