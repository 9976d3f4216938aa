//! Lines that cut a circle or each other.

use super::{DyadLowering, DyadResults, FAR_APART, Vector};
use crate::plan::{Algebra, Arithmetic, CircleAndLine, Line, Solution, TurningLine, TwoLines};
use crate::program::build::size::Size;
use crate::program::node::Op;

impl DyadLowering<'_> {
    /// u·arm + t·along = goal, with `along` of length one and known.
    pub(super) fn circle_and_line(
        &mut self,
        goal: Vector,
        arm: Vector,
        along: Vector,
    ) -> DyadResults {
        let line = Line::new(self.ssa, goal, along);
        self.ssa.name(line.foot, "foot");
        self.ssa.name(line.height, "height");
        let last = self.last_displacement();
        let beyond = self.ssa.sub(last, line.foot);
        let side = self.side(beyond);
        let circle = CircleAndLine::new(self.ssa, line, arm);
        let size = self.ssa.size(&[goal, arm]);
        let tolerance = self.tolerance(size, circle.radius);
        let root = self.root(circle.discriminant);
        let root = self.on_side(root, side);
        let solution = circle.solution(self.ssa, root);
        let sine = self.ssa.div(root, circle.radius);
        let long = self.ssa.part_of(1.0, size);
        let shift = self.ssa.div(long, circle.radius);
        let (rounded, far) = match size {
            Size::Fixed(size) => {
                let radius = self.ssa.at_start(circle.radius);
                (Size::Fixed(size / radius), size > FAR_APART * radius)
            }
            Size::Varying(_) => (Size::Varying(shift), true),
        };
        let rounding_square = self.rounding_square(shift, rounded);
        let normalises = self.choice.watching.is_some() || far;
        DyadResults {
            solution: self.normalise(solution, normalises),
            discriminant: circle.discriminant,
            tolerance,
            closes: None,
            sine,
            rounding_square,
        }
    }

    /// u·(arm + t·along) = goal: the line turns with the arm.
    pub(super) fn turning_line(&mut self, goal: Vector, arm: Vector, along: Vector) -> DyadResults {
        let line = Line::new(self.ssa, arm, along);
        let last = self.last_displacement();
        let beyond = self.ssa.add(last, line.foot);
        let side = self.side(beyond);
        let turning = TurningLine::new(self.ssa, line, goal);
        let size = self.ssa.size(&[goal, arm]);
        let height_size = self.ssa.abs(line.height);
        let tolerance = self.tolerance(size, height_size);
        let root = self.root(turning.discriminant);
        let signed = self.on_side(root, side);
        let passes_through_pin = match size {
            Size::Fixed(size) => self.ssa.at_start(line.height).abs() <= 1e-9 * size,
            Size::Varying(_) => true,
        };
        let pins_meet = self.choice.changes_branch() && passes_through_pin;
        let beside = if pins_meet {
            // It points nearly where it did.
            let ahead = self.ssa.rotate(self.last_direction(), along);
            let turn = self.ssa.dot(ahead, goal);
            self.beside_meeting_pins([root, signed], turn, (turning.square, size))
        } else {
            signed
        };
        let solution = turning.solution(self.ssa, beside);
        let mut solution = self.normalise(solution, self.choice.watching.is_some());
        let scale = self.ssa.inverse_of(size);
        let ssa = &mut *self.ssa;
        // The displacement may be any times longer than the loop is at the start: of that, only what is near zero counts.
        let grown = ssa.mul(scale, signed);
        let (one, square_grown) = (ssa.constant(1.0), ssa.mul(grown, grown));
        let bound = ssa.add(one, square_grown);
        let bound = ssa.sqrt(bound);
        let sine = ssa.div(grown, bound);
        let part = ssa.mul(scale, line.height);
        let shift = ssa.mul(part, part);
        let rounding_square = self.rounding_square(shift, Size::Fixed(1.0));
        if pins_meet {
            // The line lies along the way on which they meet, or keeps its direction.
            let first = match self.across {
                Some([x, y]) => {
                    let (back, one) = (self.ssa.neg(y), self.ssa.constant(1.0));
                    self.along([back, x], (along, one))
                }
                None => self.last[0],
            };
            solution[0] = self.unless_pins_meet(turning.square, size, solution[0], first);
        }
        DyadResults {
            solution,
            discriminant: turning.discriminant,
            tolerance,
            closes: None,
            sine,
            rounding_square,
        }
    }

    /// s·a + t·b = goal.
    pub(super) fn two_lines(&mut self, goal: Vector, lines: [Vector; 2]) -> DyadResults {
        let TwoLines { det, numerators, displacements } = TwoLines::new(self.ssa, goal, lines);
        let tolerance = self.ssa.constant(-4.0 * self.ssa.epsilon);
        if !self.choice.changes_branch() {
            let positive = self.ssa.at_start(det) > 0.0;
            let discriminant = if positive { det } else { self.ssa.neg(det) };
            return DyadResults {
                solution: displacements.map(Solution::Slide),
                discriminant,
                tolerance,
                closes: None,
                sine: det,
                rounding_square: tolerance,
            };
        }
        // Where the lines are parallel they may lie on each other: there the displacements are what they were, which is as near as rounding
        // lets them be found on either side. Else they lead beyond all bounds.
        let tiny = self.ssa.epsilon.sqrt();
        let square = self.ssa.mul(det, det);
        let rounding_square = self.ssa.constant(tiny * tiny);
        let apart = self.ssa.sub(square, rounding_square);
        let apart = self.ssa.name(apart, "apart");
        let solution = [0, 1].map(|unknown| {
            let displacement = Solution::Slide(displacements[unknown]);
            self.ssa.choose(apart, displacement, self.last[unknown])
        });
        let size = self.ssa.size(&[goal]);
        let reach = self.ssa.dot(goal, goal);
        let reach = self.ssa.sqrt(reach);
        let most = self.ssa.part_of(1.0, size);
        let reach = self.ssa.add(reach, most);
        let near = self.ssa.constant(8.0 * tiny);
        let near = self.ssa.mul(near, reach);
        let [p, q] = numerators.map(|numerator| self.ssa.abs(numerator));
        let beside = self.ssa.max(p, q);
        let on_each_other = self.ssa.sub(near, beside);
        let one = self.ssa.constant(1.0);
        let closes = self.ssa.make(Op::Choose(apart, one, on_each_other));
        DyadResults {
            solution,
            discriminant: self.ssa.abs(det),
            tolerance,
            closes: Some(closes),
            sine: det,
            rounding_square,
        }
    }
}
