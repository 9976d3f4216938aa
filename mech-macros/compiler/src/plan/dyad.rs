//! Loops of two unknowns: circles and lines that cut each other.
//!
//! The vectors round the ring add to zero, so its two unknowns contribute the goal, `−offset`. The formulas stand in an [`Algebra`]: with
//! numbers they assemble the mechanism, with symbols they are its program. The sign of a root distinguishes the two solutions; it is
//! the sign of the loop's determinant. Discriminants stay in factors: expanded they lose half of all digits where lengths differ much.

use super::algebra::Algebra;
use super::equation::Equation;
use super::unknown::{Solution, Unknown};

/// The circles and lines that a dyad intersects. Every vector is given by its two coordinates in the frame of the loop's first cluster.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Dyad<S> {
    /// Two circles, u·a + v·b = goal: the arms turn, and reach the goal together.
    TwoCircles { goal: [S; 2], arms: [[S; 2]; 2] },
    /// A circle and a line, u·arm + t·along = goal: the arm turns, and a displacement along a known direction leads on to the goal.
    CircleAndLine { goal: [S; 2], arm: [S; 2], along: [S; 2] },
    /// A line that turns with an arm, u·(arm + t·along) = goal, and reaches the goal.
    TurningLine { goal: [S; 2], arm: [S; 2], along: [S; 2] },
    /// Two lines, s·a + t·b = goal: two displacements along known directions.
    TwoLines { goal: [S; 2], lines: [[S; 2]; 2] },
}

impl<S: Copy + PartialEq> Dyad<S> {
    /// The dyad of an equation; none if it has several rings, or other than two unknowns.
    pub(crate) fn of(algebra: &mut impl Algebra<S>, equation: &Equation<S>) -> Option<Self> {
        let ([ring], [first, second]) = (&equation.rings[..], &equation.unknowns[..]) else {
            return None;
        };
        let goal = ring.offset.map(|part| algebra.neg(part));
        let slide = |unknown: usize| ring.slides.iter().find(|slide| slide.unknown == unknown);
        Some(match (first, second) {
            (Unknown::Direction(_), Unknown::Direction(_)) => {
                Self::TwoCircles { goal, arms: [ring.arms[0]?, ring.arms[1]?] }
            }
            (Unknown::Direction(_), Unknown::Slide(_)) => {
                let slide = slide(1)?;
                let along = slide.along;
                match slide.turned_by {
                    None => Self::CircleAndLine { goal, arm: ring.arms[0]?, along },
                    // The line may turn about the very point.
                    Some(_) => Self::TurningLine {
                        goal,
                        arm: ring.arms[0].unwrap_or(algebra.vector([0.0, 0.0])),
                        along,
                    },
                }
            }
            (Unknown::Slide(_), Unknown::Slide(_)) => {
                Self::TwoLines { goal, lines: [slide(0)?.along, slide(1)?.along] }
            }
            // Directions come first.
            (Unknown::Slide(_), Unknown::Direction(_)) => return None,
        })
    }

    /// All vectors that it is made from: the goal, the arms, the lines.
    pub(crate) fn vectors(&self) -> Vec<[S; 2]> {
        match *self {
            Self::TwoCircles { goal, arms: [a, b] } | Self::TwoLines { goal, lines: [a, b] } => {
                vec![goal, a, b]
            }
            Self::CircleAndLine { goal, arm, along } | Self::TurningLine { goal, arm, along } => {
                vec![goal, arm, along]
            }
        }
    }

    /// The same dyad of other values.
    pub(crate) fn map(&self, other: impl Fn(S) -> S) -> Self {
        let vector = |of: [S; 2]| of.map(&other);
        match *self {
            Self::TwoCircles { goal, arms } => {
                Self::TwoCircles { goal: vector(goal), arms: arms.map(vector) }
            }
            Self::CircleAndLine { goal, arm, along } => {
                Self::CircleAndLine { goal: vector(goal), arm: vector(arm), along: vector(along) }
            }
            Self::TurningLine { goal, arm, along } => {
                Self::TurningLine { goal: vector(goal), arm: vector(arm), along: vector(along) }
            }
            Self::TwoLines { goal, lines } => {
                Self::TwoLines { goal: vector(goal), lines: lines.map(vector) }
            }
        }
    }

    /// Returns the vector that its unknowns reach together.
    pub(crate) fn goal(&self) -> [S; 2] {
        match *self {
            Self::TwoCircles { goal, .. }
            | Self::CircleAndLine { goal, .. }
            | Self::TurningLine { goal, .. }
            | Self::TwoLines { goal, .. } => goal,
        }
    }

    /// The vectors that have a length: the goal and the arms.
    pub(crate) fn sides(&self) -> Vec<[S; 2]> {
        let count = match self {
            Self::TwoCircles { .. } => 3,
            Self::CircleAndLine { .. } | Self::TurningLine { .. } => 2,
            Self::TwoLines { .. } => 1,
        };
        self.vectors().into_iter().take(count).collect()
    }
}

/// u·a + v·b = goal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TwoCircles<S> {
    goal: [S; 2],
    arms: [[S; 2]; 2],
    /// The squares of the arms' lengths.
    squares: [S; 2],
    /// The arms' lengths.
    pub(crate) lengths: [S; 2],
    /// The square of the goal's distance.
    pub(crate) square: S,
    /// The sum of the arms' lengths.
    pub(crate) sum: S,
    /// The square of that sum.
    pub(crate) outer: S,
    /// The difference of the arms' lengths.
    pub(crate) difference: S,
    /// The square of four times the triangle's area; negative if the arms do not reach the goal.
    pub(crate) discriminant: S,
}

impl<S: Copy> TwoCircles<S> {
    pub(crate) fn new(algebra: &mut impl Algebra<S>, goal: [S; 2], arms: [[S; 2]; 2]) -> Self {
        let squares = arms.map(|arm| algebra.dot(arm, arm));
        let lengths = squares.map(|square| algebra.sqrt(square));
        let square = algebra.dot(goal, goal);
        let square = algebra.label(square, "distance_square");
        let [a, b] = lengths;
        let (sum, difference) = (algebra.add(a, b), algebra.difference(a, b));
        let outer = algebra.mul(sum, sum);
        let inner = algebra.mul(difference, difference);
        let (inside, outside) = (algebra.sub(outer, square), algebra.sub(square, inner));
        let discriminant = algebra.mul(inside, outside);
        Self {
            goal,
            arms,
            squares,
            lengths,
            square,
            sum,
            outer,
            difference,
            discriminant: algebra.label(discriminant, "discriminant"),
        }
    }

    /// The directions of both arms, from the root of the discriminant with the sign of the side.
    pub(crate) fn directions(&self, algebra: &mut impl Algebra<S>, root: S) -> [[S; 2]; 2] {
        let half = algebra.constant(0.5);
        let half_inverse = algebra.div(half, self.square);
        let half_inverse = algebra.label(half_inverse, "half_inverse");
        let excess = algebra.mul(self.sum, self.difference);
        let lean = algebra.mul(excess, half_inverse);
        let along = algebra.add(half, lean);
        let across = algebra.mul(root, half_inverse);
        let tip = algebra.rotate(self.goal, [along, across]);
        let remainder = algebra.minus(self.goal, tip);
        let first = direction(algebra, tip, self.arms[0], self.squares[0]);
        let second = direction(algebra, remainder, self.arms[1], self.squares[1]);
        [first, second]
    }

    /// The second direction, from the first.
    pub(crate) fn second(&self, algebra: &mut impl Algebra<S>, first: Solution<S>) -> Solution<S> {
        let Solution::Direction(first) = first else {
            return first;
        };
        let tip = algebra.rotate(first, self.arms[0]);
        let remainder = algebra.minus(self.goal, tip);
        Solution::Direction(direction(algebra, remainder, self.arms[1], self.squares[1]))
    }
}

/// The direction of an arm whose tip is there, from the arm in its own frame and the square of its length.
fn direction<S: Copy>(
    algebra: &mut impl Algebra<S>,
    tip: [S; 2],
    arm: [S; 2],
    square: S,
) -> [S; 2] {
    let one = algebra.constant(1.0);
    let inverse = algebra.div(one, square);
    let back = algebra.conjugate(arm);
    let back = algebra.scale(inverse, back);
    algebra.rotate(tip, back)
}

/// A line through the origin, and a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<S> {
    along: [S; 2],
    /// The distance of the point along the line.
    pub(crate) foot: S,
    /// The distance of the point to the left of the line.
    pub(crate) height: S,
}

impl<S: Copy> Line<S> {
    pub(crate) fn new(algebra: &mut impl Algebra<S>, point: [S; 2], along: [S; 2]) -> Self {
        Self { along, foot: algebra.dot(point, along), height: algebra.cross(along, point) }
    }

    /// The vector from the foot to the point, and the vector along the line by this displacement.
    fn legs(&self, algebra: &mut impl Algebra<S>, displacement: S) -> [[S; 2]; 2] {
        let across = [algebra.neg(self.along[1]), self.along[0]];
        [algebra.scale(self.height, across), algebra.scale(displacement, self.along)]
    }
}

/// u·arm + t·along = goal, with `along` of length one and known.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CircleAndLine<S> {
    line: Line<S>,
    arm: [S; 2],
    square: S,
    /// The arm's length.
    pub(crate) radius: S,
    /// Negative if the line does not meet the circle.
    pub(crate) discriminant: S,
}

impl<S: Copy> CircleAndLine<S> {
    /// The line is that of the goal.
    pub(crate) fn new(algebra: &mut impl Algebra<S>, line: Line<S>, arm: [S; 2]) -> Self {
        let square = algebra.dot(arm, arm);
        let radius = algebra.sqrt(square);
        let below = algebra.sub(radius, line.height);
        let above = algebra.add(radius, line.height);
        let discriminant = algebra.mul(below, above);
        Self {
            line,
            arm,
            square,
            radius,
            discriminant: algebra.label(discriminant, "discriminant"),
        }
    }

    /// The arm's direction and the displacement, from the root of the discriminant with the sign of the side.
    pub(crate) fn solution(&self, algebra: &mut impl Algebra<S>, root: S) -> [Solution<S>; 2] {
        let displacement = algebra.add(self.line.foot, root);
        let [up, back] = self.line.legs(algebra, root);
        let tip = algebra.minus(up, back);
        let direction = direction(algebra, tip, self.arm, self.square);
        [Solution::Direction(direction), Solution::Slide(displacement)]
    }
}

/// u·(arm + t·along) = goal: the line turns with the arm.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TurningLine<S> {
    line: Line<S>,
    goal: [S; 2],
    /// The square of the goal's distance.
    pub(crate) square: S,
    /// Negative if the line stays farther from the origin than the goal.
    pub(crate) discriminant: S,
}

impl<S: Copy> TurningLine<S> {
    /// The line is that of the arm.
    pub(crate) fn new(algebra: &mut impl Algebra<S>, line: Line<S>, goal: [S; 2]) -> Self {
        let square = algebra.dot(goal, goal);
        let square = algebra.label(square, "distance_square");
        let height_square = algebra.mul(line.height, line.height);
        let discriminant = algebra.sub(square, height_square);
        Self { line, goal, square, discriminant: algebra.label(discriminant, "discriminant") }
    }

    /// The arm's direction and the displacement, from the root of the discriminant with the sign of the side.
    pub(crate) fn solution(&self, algebra: &mut impl Algebra<S>, root: S) -> [Solution<S>; 2] {
        let displacement = algebra.sub(root, self.line.foot);
        let [up, out] = self.line.legs(algebra, root);
        let tip = algebra.plus(up, out);
        let one = algebra.constant(1.0);
        let inverse = algebra.div(one, self.square);
        let inverse = algebra.label(inverse, "inverse");
        let back = algebra.conjugate(tip);
        let turn = algebra.rotate(self.goal, back);
        let direction = algebra.scale(inverse, turn);
        [Solution::Direction(direction), Solution::Slide(displacement)]
    }
}

/// s·a + t·b = goal, by Cramer's rule.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TwoLines<S> {
    /// The sine of the angle between the lines.
    pub(crate) det: S,
    /// The displacements, times the determinant.
    pub(crate) numerators: [S; 2],
    /// The displacements.
    pub(crate) displacements: [S; 2],
}

impl<S: Copy> TwoLines<S> {
    pub(crate) fn new(algebra: &mut impl Algebra<S>, goal: [S; 2], [a, b]: [[S; 2]; 2]) -> Self {
        let det = algebra.cross(a, b);
        let one = algebra.constant(1.0);
        let inverse = algebra.div(one, det);
        let numerators = [algebra.cross(goal, b), algebra.cross(a, goal)];
        Self {
            det,
            numerators,
            displacements: numerators.map(|numerator| algebra.mul(numerator, inverse)),
        }
    }
}
