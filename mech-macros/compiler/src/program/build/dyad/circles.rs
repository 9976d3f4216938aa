//! Two circles that cut each other.

use super::{DyadLowering, DyadResults, FAR_APART, TOLERANCE, Vector};
use crate::plan::{Algebra, Arithmetic, Solution, TwoCircles};
use crate::program::build::size::Size;
use crate::program::node::{Op, Value};

impl DyadLowering<'_> {
    /// u·a + v·b = goal.
    pub(super) fn two_circles(&mut self, goal: Vector, arms: [Vector; 2]) -> DyadResults {
        let last = self.last_direction();
        let tip = self.ssa.rotate(last, arms[0]);
        let turn = self.ssa.cross(goal, tip);
        let side = self.side(turn);
        let circles = TwoCircles::new(self.ssa, goal, arms);
        let [a, b] = circles.lengths;
        let product = self.ssa.mul(a, b);
        let tolerance = self.ssa.constant(8.0 * TOLERANCE * self.ssa.epsilon);
        let gap = self.ssa.mul(tolerance, circles.sum);
        let gap = self.ssa.mul(gap, product);
        let tolerance = self.by_distance(&circles, gap);
        let root = self.root(circles.discriminant);
        let signed = self.on_side(root, side);
        let [long, short, wide] = [a, b, product].map(|value| self.ssa.at_start(value));
        let size = self.ssa.size_or(circles.sum, long + short);
        let alike = size.varies() || (long - short).abs() <= 1e-9 * (long + short);
        let pins_meet = self.choice.changes_branch() && alike;
        let beside = if pins_meet {
            self.beside_meeting_pins([root, signed], turn, (circles.square, size))
        } else {
            signed
        };
        let directions = circles.directions(self.ssa, beside).map(Solution::Direction);
        let two = self.ssa.constant(2.0);
        let scale = self.ssa.mul(two, product);
        let sine = self.ssa.div(signed, scale);
        // Where rounding passes for closed, it must not stretch a link.
        let stretches = self.choice.watching.is_some()
            || self.choice.pins_near
            || self.are_far_apart(a, b, circles.square);
        let mut solution = self.normalise(directions, stretches);
        if pins_meet {
            // The one lies across the way on which they meet, or keeps its direction; the other follows from it.
            let first = match self.across {
                Some(across) => self.along(across, (arms[0], a)),
                None => self.last[0],
            };
            solution[0] = self.unless_pins_meet(circles.square, size, solution[0], first);
            let second = circles.second(self.ssa, solution[0]);
            solution[1] = self.unless_pins_meet(circles.square, size, solution[1], second);
        }
        // Rounding shifts the distance of the centres by a part of the sum of the lengths, however short it is.
        let share = self.ssa.div(circles.sum, product);
        let shift = self.by_distance(&circles, share);
        let rounded = match size {
            Size::Fixed(size) => Size::Fixed(size * size / wide),
            Size::Varying(_) => Size::Varying(self.ssa.div(circles.outer, product)),
        };
        DyadResults {
            solution,
            discriminant: circles.discriminant,
            tolerance,
            closes: None,
            sine,
            rounding_square: self.rounding_square(shift, rounded),
        }
    }

    /// A number times the distance d of the centres, at a dead point.
    ///
    /// A gap of `g` makes the discriminant −g · 2d · 4ab there: at the outer with d = s = a + b, at the inner with d = m = |a − b|. For all
    /// between, d is taken as the chord of the root of its square: (d² + sm) / (s + m).
    fn by_distance(&mut self, circles: &TwoCircles<Value>, number: Value) -> Value {
        let ssa = &mut *self.ssa;
        let least = ssa.abs(circles.difference);
        let (both, within) = (ssa.add(circles.sum, least), ssa.mul(circles.sum, least));
        let scale = ssa.div(number, both);
        let chord = ssa.add(circles.square, within);
        ssa.mul(scale, chord)
    }

    /// The root of the discriminant, with the sign of the dyad's side. Where pins nearly meet, the side is that of the last position.
    pub(super) fn beside_meeting_pins(
        &mut self,
        [root, signed]: [Value; 2],
        turn: Value,
        (square, size): (Value, Size),
    ) -> Value {
        let near = self.beyond_rounding(square, size);
        let side = self.ssa.make(Op::Choose(near, signed, turn));
        self.ssa.copysign(root, side)
    }

    /// A number that is negative where pins nearly meet. There rounding hides the side of a dyad with equal arms, and it keeps the side
    /// on which it was.
    fn beyond_rounding(&mut self, square: Value, size: Size) -> Value {
        let roundings = self.roundings();
        let scale = self.ssa.part_of(4.0 * self.ssa.epsilon, size);
        let near = self.ssa.mul(scale, roundings);
        let near = self.ssa.mul(near, near);
        self.ssa.sub(square, near)
    }

    /// Whether the sides of a triangle differ so much in length that rounding spoils the direction of the shortest.
    fn are_far_apart(&self, a: Value, b: Value, square: Value) -> bool {
        let [a, b, square] = [a, b, square].map(|value| self.ssa.at_start(value));
        let greatest = a.max(b).max(square.sqrt());
        greatest > FAR_APART * a.min(b)
    }
}
