//! Dyads in closed form: whether they close, and on which side they lie.

mod circles;
mod lines;

use super::size::Size;
use crate::bug::bug;
use crate::model::InputId;
use crate::plan::{Algebra, Arithmetic, Dyad, Solution};
use crate::program::builder::SsaBuilder;
use crate::program::choice::Choice;
use crate::program::closed_form::ClosedForm;
use crate::program::node::{Op, Value};

/// A gap, in units of rounding of the loop's size, that passes for closed.
const TOLERANCE: f64 = 64.0;

/// If lengths differ by more than this factor, directions are brought back to length one: rounding would spoil the short link's.
const FAR_APART: f64 = 32.0;

type Vector = [Value; 2];

/// Lowers a dyad to operations.
pub(super) struct DyadLowering<'a> {
    pub(super) ssa: &'a mut SsaBuilder,
    pub(super) choice: &'a Choice,
    /// Its two unknowns at the last position.
    pub(super) last: &'a [Solution<Value>],
    /// A vector at right angles to the goal, if that is a chord; where pins meet, its length is one.
    pub(super) across: Option<Vector>,
}

/// The results of a closed form.
struct DyadResults {
    solution: [Solution<Value>; 2],
    discriminant: Value,
    tolerance: Value,
    /// A number that is negative if it does not close, where discriminant and tolerance do not say it.
    closes: Option<Value>,
    sine: Value,
    rounding_square: Value,
}

/// The side on which a dyad lies.
#[derive(Clone, Copy)]
enum Side {
    /// Always this one.
    Fixed(bool),
    /// The side on which it was: the sign of a number of the state.
    Carried(Value),
}

impl DyadLowering<'_> {
    /// The closed form of a dyad and its unknowns: it closes the loop of this number, between joints of these names.
    pub(super) fn lower(
        &mut self,
        dyad: Dyad<Value>,
        number: usize,
        place: &str,
    ) -> (ClosedForm, [Solution<Value>; 2]) {
        let found = match dyad {
            Dyad::TwoCircles { goal, arms } => self.two_circles(goal, arms),
            Dyad::CircleAndLine { goal, arm, along } => self.circle_and_line(goal, arm, along),
            Dyad::TurningLine { goal, arm, along } => self.turning_line(goal, arm, along),
            Dyad::TwoLines { goal, lines } => self.two_lines(goal, lines),
        };
        let margin = match (self.choice.proved, found.closes) {
            (true, _) => self.ssa.constant(1.0),
            (false, Some(closes)) => closes,
            (false, None) => self.ssa.add(found.discriminant, found.tolerance),
        };
        let sides = dyad.sides();
        let margin = if self.ssa.any_varies(sides[1..].as_flattened()) {
            self.ssa.unless_stretched(margin, &found.solution)
        } else {
            margin
        };
        let numbers = found.solution.iter().flat_map(Solution::numbers);
        let closed = ClosedForm {
            number,
            place: place.to_owned(),
            discriminant: found.discriminant,
            tolerance: found.tolerance,
            margin: self.ssa.name(margin, "margin"),
            sine: found.sine,
            rounding_square: found.rounding_square,
            has_branches: !matches!(dyad, Dyad::TwoLines { .. }),
            found: numbers.collect(),
            size: self.ssa.extent(&sides),
            dyad,
        };
        (closed, found.solution)
    }

    /// The direction of the first unknown at the last position.
    fn last_direction(&self) -> Vector {
        match self.last[0] {
            Solution::Direction(direction) => direction,
            Solution::Slide(_) => bug!("a dyad that turns has no direction"),
        }
    }

    /// The displacement of the second unknown at the last position.
    fn last_displacement(&self) -> Value {
        match self.last[1] {
            Solution::Slide(displacement) => displacement,
            Solution::Direction(_) => bug!("a dyad that slides has no displacement"),
        }
    }

    /// On which side a dyad lies, from a number that is positive on one and negative on the other.
    fn side(&mut self, signed: Value) -> Side {
        let positive = self.choice.side;
        let positive = positive.unwrap_or_else(|| self.ssa.at_start(signed) > 0.0);
        if self.choice.changes_branch() {
            let sine = if positive { 1.0 } else { -1.0 };
            Side::Carried(self.ssa.carry(sine).last)
        } else {
            Side::Fixed(positive)
        }
    }

    /// The root of a discriminant. If that is negative by rounding, zero.
    fn root(&mut self, discriminant: Value) -> Value {
        let discriminant = if self.choice.proved {
            discriminant
        } else {
            let zero = self.ssa.constant(0.0);
            self.ssa.max(discriminant, zero)
        };
        let root = self.ssa.sqrt(discriminant);
        self.ssa.name(root, "root")
    }

    /// A root with the sign of a side.
    fn on_side(&mut self, root: Value, side: Side) -> Value {
        match side {
            Side::Fixed(true) => root,
            Side::Fixed(false) => self.ssa.neg(root),
            Side::Carried(carried) => {
                let signed = self.ssa.copysign(root, carried);
                self.ssa.name(signed, "signed_root")
            }
        }
    }

    /// The tolerance of a difference of squares: so much rounding of twice a size, times a length.
    fn tolerance(&mut self, size: Size, length: Value) -> Value {
        let tolerance = self.ssa.part_of(2.0 * TOLERANCE * self.ssa.epsilon, size);
        self.ssa.mul(tolerance, length)
    }

    /// The number of roundings that a length has suffered: the motors' values are rounded too, the more the farther they have turned, and the
    /// farther gears turn what they drive. Angles that loops give to gears come with the rounding of these loops.
    fn roundings(&mut self) -> Value {
        const OF_LOOPS: f64 = 16.0;
        let mut drivers = self.ssa.gains.clone();
        let mut given = OF_LOOPS;
        for (driver, gain) in &drivers {
            if !matches!(self.ssa.op(*driver), Op::Input(_)) {
                given += OF_LOOPS * gain;
            }
        }
        for motor in 0..self.ssa.motors {
            let value = self.ssa.make(Op::Input(InputId::new(motor)));
            drivers.entry(value).or_insert(1.0);
        }
        let mut turned = self.ssa.constant(0.0);
        for (driver, gain) in drivers {
            let value = self.ssa.abs(driver);
            let gain = self.ssa.constant(gain);
            let value = self.ssa.mul(gain, value);
            turned = self.ssa.add(turned, value);
        }
        let (two, given) = (self.ssa.constant(2.0), self.ssa.constant(given));
        let turned = self.ssa.mul(two, turned);
        self.ssa.add(given, turned)
    }

    /// The square of a sine below which rounding hides its sign: where rounding shifts the square of the sine by this part of
    /// epsilon, and not less than what rounding of lengths does to the sine itself.
    fn rounding_square(&mut self, shift: Value, sine: Size) -> Value {
        let epsilon = self.ssa.epsilon;
        let roundings = self.roundings();
        let least = self.ssa.part_of(epsilon, sine);
        let least = self.ssa.mul(least, roundings);
        let least = self.ssa.mul(least, least);
        let shift_by = self.ssa.constant(16.0 * epsilon);
        let shift = self.ssa.mul(shift_by, shift);
        self.ssa.add(shift, least)
    }

    /// A solution whose directions are brought back to length one, if that is needed.
    fn normalise(&mut self, solution: [Solution<Value>; 2], needed: bool) -> [Solution<Value>; 2] {
        solution.map(|unknown| match unknown {
            Solution::Direction(direction) if needed => {
                Solution::Direction(self.ssa.normalise(direction, "closed"))
            }
            unknown => unknown,
        })
    }

    /// The direction of an arm that points along a way or against it, whichever is nearer to where it pointed.
    fn along(&mut self, way: Vector, (arm, length): (Vector, Value)) -> Solution<Value> {
        let pointed = self.ssa.rotate(self.last_direction(), arm);
        let ahead = self.ssa.dot(way, pointed);
        let one = self.ssa.constant(1.0);
        let inverse = self.ssa.div(one, length);
        let scale = self.ssa.copysign(inverse, ahead);
        let back = self.ssa.conjugate(arm);
        let direction = self.ssa.rotate(way, back);
        Solution::Direction(self.ssa.scale(scale, direction))
    }

    /// A direction, or another one where the pins of the dyad meet: there any direction closes the loop.
    fn unless_pins_meet(
        &mut self,
        square: Value,
        size: Size,
        direction: Solution<Value>,
        other: Solution<Value>,
    ) -> Solution<Value> {
        let part = 0.5 * TOLERANCE * self.ssa.epsilon;
        let least = match size {
            Size::Fixed(size) => self.ssa.constant((part * size).powi(2)),
            Size::Varying(_) => {
                let least = self.ssa.part_of(part, size);
                self.ssa.mul(least, least)
            }
        };
        let apart = self.ssa.sub(square, least);
        let apart = self.ssa.name(apart, "apart");
        self.ssa.choose(apart, direction, other)
    }
}
