//! The solutions of dyads by numbers: at compile time, to find every assembly.

use super::algebra::Numbers;
use super::dyad::{CircleAndLine, Dyad, Line, TurningLine, TwoCircles, TwoLines};
use super::equation::Equation;
use super::unknown::Solution;

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

/// Solves a loop of one ring and two unknowns; none for any other loop.
pub(super) fn solve(equation: &Equation<f64>) -> Option<LoopSolutions> {
    let numbers = &mut Numbers;
    Some(match Dyad::of(numbers, equation)? {
        Dyad::TwoCircles { goal, arms } => {
            let circles = TwoCircles::new(numbers, goal, arms);
            let distance = circles.square.sqrt();
            let reach = Reach {
                gap: (distance - circles.sum).max(circles.difference.abs() - distance),
                size: distance + circles.sum,
                discriminant: circles.discriminant,
                greatest_root: 2.0 * circles.lengths[0] * circles.lengths[1],
            };
            reach.solutions(|root| circles.directions(numbers, root).map(Solution::Direction))
        }
        Dyad::CircleAndLine { goal, arm, along } => {
            let line = Line::new(numbers, goal, along);
            let circle = CircleAndLine::new(numbers, line, arm);
            let reach = Reach {
                gap: line.height.abs() - circle.radius,
                size: goal[0].hypot(goal[1]) + circle.radius,
                discriminant: circle.discriminant,
                greatest_root: circle.radius,
            };
            reach.solutions(|root| circle.solution(numbers, root))
        }
        Dyad::TurningLine { goal, arm, along } => {
            let line = Line::new(numbers, arm, along);
            let turning = TurningLine::new(numbers, line, goal);
            let distance = turning.square.sqrt();
            let reach = Reach {
                gap: line.height.abs() - distance,
                size: arm[0].hypot(arm[1]) + distance,
                discriminant: turning.discriminant,
                greatest_root: distance,
            };
            reach.solutions(|root| turning.solution(numbers, root))
        }
        Dyad::TwoLines { goal, lines } => {
            let crossing = TwoLines::new(numbers, goal, lines);
            if crossing.det.is_nan() || crossing.det.abs() < PARALLEL {
                return Some(LoopSolutions::DeadPoint);
            }
            LoopSolutions::Found(vec![crossing.displacements.map(Solution::Slide).to_vec()])
        }
    })
}

/// Whether a dyad reaches its goal.
struct Reach {
    /// The gap, in scene units; not positive if the loop closes.
    gap: f64,
    /// The length that the gap is measured by.
    size: f64,
    discriminant: f64,
    /// The root of the discriminant at a transmission angle of 90°.
    greatest_root: f64,
}

impl Reach {
    /// The two solutions, one for each sign of the root.
    fn solutions(&self, mut solution: impl FnMut(f64) -> [Solution<f64>; 2]) -> LoopSolutions {
        if self.gap > 1e-9 * self.size {
            return LoopSolutions::Gap(self.gap);
        }
        let root = self.discriminant.max(0.0).sqrt();
        let sine = root / self.greatest_root;
        if sine.is_nan() || sine < DEAD {
            return LoopSolutions::DeadPoint;
        }
        let normalise = |unknown| match unknown {
            // The remaining gap must not stretch a link.
            Solution::Direction([cos, sin]) => {
                let length = f64::hypot(cos, sin);
                Solution::Direction([cos / length, sin / length])
            }
            slide @ Solution::Slide(_) => slide,
        };
        let both = [root, -root].map(|root| solution(root).map(normalise).to_vec());
        LoopSolutions::Found(both.to_vec())
    }
}
