//! Loops of two unknowns in closed form: circles and lines cut each other.
//!
//! The way round the ring is zero: what its unknowns contribute is the goal, `−offset`. Each form tells the two solutions
//! apart by the sign of a root, which is the sign of the loop's determinant. Discriminants are kept in factors: expanded they
//! lose half of all digits where lengths differ much.

use super::Writer;
use super::size::Size;
use crate::plan::{Algebra, Equation, Loop, Slide, Solution, Unknown};
use crate::program::choice::Choice;
use crate::program::closed_form::{ClosedForm, Form};
use crate::program::node::{Op, Value};

/// A gap, in units of rounding of the loop's size, that passes for closed.
const TOLERANCE: f64 = 64.0;

/// Directions are brought back to length one where lengths differ by more than this: the short link's would suffer.
const FAR_APART: f64 = 32.0;

type Vector = [Value; 2];

/// What a closed form finds.
struct Found {
    solution: Vec<Solution<Value>>,
    discriminant: Value,
    tolerance: Value,
    /// What is not negative if it closes, where slack and floor do not tell.
    closes: Option<Value>,
    sine: Value,
    rounding_square: Value,
    form: Form,
}

/// The side on which a dyad lies.
#[derive(Clone, Copy)]
enum Side {
    /// Always this one.
    Fixed(bool),
    /// That on which it was: the sign of a number that is carried.
    Carried(Value),
}

impl Writer<'_> {
    /// The closed form of a loop, if it has one: a single ring of two unknowns that rolling does not tie.
    pub(super) fn dyad(
        &mut self,
        closing: &Loop,
        equation: &Equation<Value>,
        firsts: &[Solution<Value>],
        choice: &Choice,
    ) -> Option<(ClosedForm, Vec<Solution<Value>>)> {
        let ([ring], [first, second]) = (&equation.rings[..], &equation.unknowns[..]) else {
            return None;
        };
        if !closing.ties.is_empty() {
            return None;
        }
        let goal = ring.offset.map(|part| self.builder.neg(part));
        let slide = |unknown: usize| ring.slides.iter().find(|slide| slide.unknown == unknown);
        let found = match (first, second) {
            (Unknown::Direction(_), Unknown::Direction(_)) => {
                self.two_circles(goal, [ring.arms[0]?, ring.arms[1]?], firsts, choice)
            }
            (Unknown::Direction(_), Unknown::Slide(_)) => match *slide(1)? {
                Slide {
                    along,
                    turned_by: None,
                    ..
                } => self.circle_and_line(goal, ring.arms[0]?, along, firsts, choice),
                Slide { along, .. } => {
                    // The line may turn about the very point.
                    let arm = ring.arms[0].unwrap_or(self.builder.vector([0.0, 0.0]));
                    self.line_that_turns(goal, arm, along, firsts, choice)
                }
            },
            (Unknown::Slide(_), Unknown::Slide(_)) => {
                let lines = [slide(0)?.along, slide(1)?.along];
                self.two_lines(goal, lines, firsts, choice)
            }
            // Directions come first.
            (Unknown::Slide(_), Unknown::Direction(_)) => return None,
        };
        let margin = match (choice.proved, found.closes) {
            (true, _) => self.builder.constant(1.0),
            (false, Some(closes)) => closes,
            (false, None) => self.builder.add(found.discriminant, found.tolerance),
        };
        let arms: Vec<Value> = ring.arms.iter().flatten().flatten().copied().collect();
        let margin = if self.any_varies(&arms) {
            self.unless_stretched(margin, &found.solution)
        } else {
            margin
        };
        let closed = ClosedForm {
            number: self.loops - 1,
            place: String::new(),
            discriminant: found.discriminant,
            tolerance: found.tolerance,
            margin: self.builder.name(margin, "margin"),
            sine: found.sine,
            rounding_square: found.rounding_square,
            has_branches: !matches!(first, Unknown::Slide(_)),
            found: Vec::new(),
            form: found.form,
        };
        Some((closed, found.solution))
    }

    /// u·a + v·b = goal.
    fn two_circles(
        &mut self,
        goal: Vector,
        [a, b]: [Vector; 2],
        firsts: &[Solution<Value>],
        choice: &Choice,
    ) -> Found {
        let side = match firsts[0] {
            Solution::Direction(direction) => {
                let tip = self.builder.turned(direction, a);
                let turn = self.builder.cross(goal, tip);
                self.side(choice, turn)
            }
            Solution::Slide(_) => Side::Fixed(true),
        };
        let (a_square, b_square) = (self.builder.dot(a, a), self.builder.dot(b, b));
        let (a_length, b_length) = (self.builder.sqrt(a_square), self.builder.sqrt(b_square));
        let builder = &mut self.builder;
        let square = builder.dot(goal, goal);
        let square = builder.name(square, "distance_square");
        let (sum, difference) = (
            builder.add(a_length, b_length),
            builder.sub(a_length, b_length),
        );
        let (outer, inner) = (builder.mul(sum, sum), builder.mul(difference, difference));
        let (inside, outside) = (builder.sub(outer, square), builder.sub(square, inner));
        let discriminant = builder.mul(inside, outside);
        let discriminant = builder.name(discriminant, "discriminant");
        // A gap of `g` makes the discriminant −g · 2d · 4ab at a dead point: at the outer with a distance d of s = a + b, at the
        // inner of m = |a − b|. For all between, d is taken as the chord of the root of its square: (d² + sm) / (s + m).
        let product = builder.mul(a_length, b_length);
        let least = builder.abs(difference);
        let (both, within) = (builder.add(sum, least), builder.mul(sum, least));
        let tolerance = builder.constant(8.0 * TOLERANCE * self.model.precision.epsilon());
        let gap = builder.mul(tolerance, sum);
        let scale = builder.mul(gap, product);
        let scale = builder.div(scale, both);
        let chord = builder.add(square, within);
        let tolerance = builder.mul(scale, chord);
        let root = self.root(discriminant, choice);
        let signed = self.on_side(root, side);
        let [long, short, wide] =
            [a_length, b_length, product].map(|value| self.builder.at_start(value));
        let size = self.size_or(sum, long + short);
        let alike = size.varies() || (long - short).abs() <= 1e-9 * (long + short);
        let pins_meet = choice.changes_branch() && alike;
        let aside = if pins_meet {
            self.nearest_side(goal, a, square, size, (root, signed), firsts[0])
        } else {
            signed
        };
        let builder = &mut self.builder;
        let half = builder.constant(0.5);
        let half_inverse = builder.div(half, square);
        let half_inverse = builder.name(half_inverse, "half_inverse");
        let excess = builder.mul(sum, difference);
        let lean = builder.mul(excess, half_inverse);
        let along = builder.add(half, lean);
        let across = builder.mul(aside, half_inverse);
        let tip = builder.turned(goal, [along, across]);
        let remainder = builder.minus(goal, tip);
        let unit = |builder: &mut crate::program::builder::Builder,
                    tip: Vector,
                    arm: Vector,
                    square: Value| {
            let one = builder.constant(1.0);
            let inverse = builder.div(one, square);
            let back = builder.conjugate(arm);
            let back = builder.scaled(inverse, back);
            builder.turned(tip, back)
        };
        let first = unit(builder, tip, a, a_square);
        let second = unit(builder, remainder, b, b_square);
        let two = builder.constant(2.0);
        let scale = builder.mul(two, product);
        let sine = builder.div(signed, scale);
        // Where rounding is let pass for closed, it must not stretch a link.
        let apart = choice.watching.is_some()
            || choice.pins_near
            || self.far_apart(a_length, b_length, square);
        let mut directions = [first, second].map(|direction| {
            if apart {
                self.normalised(direction, "closed")
            } else {
                direction
            }
        });
        if pins_meet {
            // The one keeps its direction, the other follows from it.
            directions[0] = self.unless_pins_meet(square, size, directions[0], firsts[0]);
            let side = self.builder.turned(directions[0], a);
            let remainder = self.builder.minus(goal, side);
            let follows = unit(&mut self.builder, remainder, b, b_square);
            directions[1] =
                self.unless_pins_meet(square, size, directions[1], Solution::Direction(follows));
        }
        let shift = self.builder.div(square, product);
        let rounded = match size {
            Size::Fixed(size) => Size::Fixed(size * size / wide),
            Size::Varying(_) => Size::Varying(self.builder.div(outer, product)),
        };
        let rounding_square = self.rounding_square(shift, rounded);
        Found {
            solution: directions.map(Solution::Direction).to_vec(),
            discriminant,
            tolerance,
            closes: None,
            sine,
            rounding_square,
            form: Form::TwoCircles { goal, arms: [a, b] },
        }
    }

    /// Where pins nearly meet, on which side of the line between them a dyad of equal lengths lies is hidden by rounding: it lies on
    /// that on which it was.
    fn nearest_side(
        &mut self,
        goal: Vector,
        arm: Vector,
        square: Value,
        size: Size,
        (root, signed): (Value, Value),
        last: Solution<Value>,
    ) -> Value {
        let Solution::Direction(last) = last else {
            return signed;
        };
        let rounded = self.rounded();
        let scale = self.part_of(4.0 * self.model.precision.epsilon(), size);
        let near = self.builder.mul(scale, rounded);
        let near = self.builder.mul(near, near);
        let beyond = self.builder.sub(square, near);
        let tip = self.builder.turned(last, arm);
        let turn = self.builder.cross(goal, tip);
        let side = self.builder.make(Op::Choose(beyond, signed, turn));
        self.builder.copysign(root, side)
    }

    /// How many roundings a length at hand has suffered: the motors' values are rounded too, the more the farther they have turned.
    fn rounded(&mut self) -> Value {
        let mut turned = self.builder.constant(0.0);
        for motor in self.model.motor_ids() {
            let value = self.builder.make(Op::Motor(motor.index()));
            let value = self.builder.abs(value);
            turned = self.builder.add(turned, value);
        }
        let (two, sixteen) = (self.builder.constant(2.0), self.builder.constant(16.0));
        let turned = self.builder.mul(two, turned);
        self.builder.add(sixteen, turned)
    }

    /// Whether the lengths of a triangle differ so much that its short side's direction suffers.
    fn far_apart(&self, a: Value, b: Value, square: Value) -> bool {
        let [a, b, square] = [a, b, square].map(|value| self.builder.at_start(value));
        let greatest = a.max(b).max(square.sqrt());
        greatest > FAR_APART * a.min(b)
    }

    /// u·arm + t·along = goal, with `along` of length one and known.
    fn circle_and_line(
        &mut self,
        goal: Vector,
        arm: Vector,
        along: Vector,
        firsts: &[Solution<Value>],
        choice: &Choice,
    ) -> Found {
        let builder = &mut self.builder;
        let foot = builder.dot(goal, along);
        let foot = builder.name(foot, "foot");
        let height = builder.cross(along, goal);
        let height = builder.name(height, "height");
        let side = match firsts[1] {
            Solution::Slide(displacement) => {
                let beyond = builder.sub(displacement, foot);
                self.side(choice, beyond)
            }
            Solution::Direction(_) => Side::Fixed(true),
        };
        let builder = &mut self.builder;
        let square = builder.dot(arm, arm);
        let radius = builder.sqrt(square);
        let (below, above) = (builder.sub(radius, height), builder.add(radius, height));
        let discriminant = builder.mul(below, above);
        let discriminant = builder.name(discriminant, "discriminant");
        let size = self.size(&[goal, arm]);
        let tolerance = self.rounding(size, radius);
        let root = self.root(discriminant, choice);
        let root = self.on_side(root, side);
        let builder = &mut self.builder;
        let displacement = builder.add(foot, root);
        // What is left for the arm: across the line the height, along it back from where the line was left.
        let across = [builder.neg(along[1]), along[0]];
        let (up, back) = (builder.scaled(height, across), builder.scaled(root, along));
        let tip = builder.minus(up, back);
        let one = builder.constant(1.0);
        let inverse = builder.div(one, square);
        let conjugate = builder.conjugate(arm);
        let conjugate = builder.scaled(inverse, conjugate);
        let direction = builder.turned(tip, conjugate);
        let sine = builder.div(root, radius);
        let long = self.part_of(1.0, size);
        let shift = self.builder.div(long, radius);
        let (rounded, far) = match size {
            Size::Fixed(size) => {
                let radius = self.builder.at_start(radius);
                (Size::Fixed(size / radius), size > FAR_APART * radius)
            }
            Size::Varying(_) => (Size::Varying(shift), true),
        };
        let rounding_square = self.rounding_square(shift, rounded);
        let direction = if choice.watching.is_some() || far {
            self.normalised(direction, "closed")
        } else {
            direction
        };
        Found {
            solution: vec![
                Solution::Direction(direction),
                Solution::Slide(displacement),
            ],
            discriminant,
            tolerance,
            closes: None,
            sine,
            rounding_square,
            form: Form::CircleAndLine { goal, arm, along },
        }
    }

    /// u·(arm + t·along) = goal: the line turns with the arm.
    fn line_that_turns(
        &mut self,
        goal: Vector,
        arm: Vector,
        along: Vector,
        firsts: &[Solution<Value>],
        choice: &Choice,
    ) -> Found {
        let builder = &mut self.builder;
        let foot = builder.dot(arm, along);
        let height = builder.cross(along, arm);
        let side = match firsts[1] {
            Solution::Slide(displacement) => {
                let beyond = builder.add(displacement, foot);
                self.side(choice, beyond)
            }
            Solution::Direction(_) => Side::Fixed(true),
        };
        let builder = &mut self.builder;
        let square = builder.dot(goal, goal);
        let square = builder.name(square, "distance_square");
        let height_square = builder.mul(height, height);
        let discriminant = builder.sub(square, height_square);
        let discriminant = builder.name(discriminant, "discriminant");
        let size = self.size(&[goal, arm]);
        let at_start = self.size_at_start(&[goal, arm]);
        let height_size = self.builder.abs(height);
        let tolerance = self.rounding(size, height_size);
        let root = self.root(discriminant, choice);
        let root = self.on_side(root, side);
        let builder = &mut self.builder;
        let displacement = builder.sub(root, foot);
        let across = [builder.neg(along[1]), along[0]];
        let (up, out) = (builder.scaled(height, across), builder.scaled(root, along));
        let tip = builder.plus(up, out);
        let one = builder.constant(1.0);
        let inverse = builder.div(one, square);
        let inverse = builder.name(inverse, "inverse");
        let back = builder.conjugate(tip);
        let turned = builder.turned(goal, back);
        let direction = builder.scaled(inverse, turned);
        let direction = if choice.watching.is_some() {
            self.normalised(direction, "closed")
        } else {
            direction
        };
        let scale = self.inverse_of(size);
        let builder = &mut self.builder;
        // The way may be any times longer than the loop is at the start: of that, only what is near zero tells.
        let grown = builder.mul(scale, root);
        let (one, square_grown) = (builder.constant(1.0), builder.mul(grown, grown));
        let bound = builder.add(one, square_grown);
        let bound = builder.sqrt(bound);
        let sine = builder.div(grown, bound);
        let part = builder.mul(scale, height);
        let shift = builder.mul(part, part);
        let rounding_square = self.rounding_square(shift, Size::Fixed(1.0));
        let through = match size {
            Size::Fixed(size) => self.builder.at_start(height).abs() <= 1e-9 * size,
            Size::Varying(_) => true,
        };
        let direction = if choice.changes_branch() && through {
            self.unless_pins_meet(square, size, direction, firsts[0])
        } else {
            direction
        };
        Found {
            solution: vec![
                Solution::Direction(direction),
                Solution::Slide(displacement),
            ],
            discriminant,
            tolerance,
            closes: None,
            sine,
            rounding_square,
            form: Form::TurningLine {
                goal,
                arm,
                along,
                size: at_start,
            },
        }
    }

    /// s·a + t·b = goal.
    fn two_lines(
        &mut self,
        goal: Vector,
        lines: [Vector; 2],
        firsts: &[Solution<Value>],
        choice: &Choice,
    ) -> Found {
        let [a, b] = lines;
        let builder = &mut self.builder;
        let det = builder.cross(a, b);
        let one = builder.constant(1.0);
        let inverse = builder.div(one, det);
        let (p, q) = (builder.cross(goal, b), builder.cross(a, goal));
        let displacements = [builder.mul(p, inverse), builder.mul(q, inverse)];
        let least = -4.0 * self.model.precision.epsilon();
        let tolerance = builder.constant(least);
        let form = Form::TwoLines { goal, lines };
        if !choice.changes_branch() {
            let positive = builder.at_start(det) > 0.0;
            let discriminant = if positive { det } else { builder.neg(det) };
            return Found {
                solution: displacements.map(Solution::Slide).to_vec(),
                discriminant,
                tolerance,
                closes: None,
                sine: det,
                rounding_square: tolerance,
                form,
            };
        }
        // Where the lines are parallel they may lie on each other: there the ways are what they were, which is as near as rounding
        // lets them be found on either side. Else they lead beyond all bounds.
        let tiny = self.model.precision.epsilon().sqrt();
        let square = builder.mul(det, det);
        let rounding_square = builder.constant(tiny * tiny);
        let apart = builder.sub(square, rounding_square);
        let apart = builder.name(apart, "apart");
        let mut solution = Vec::new();
        for (displacement, last) in displacements.into_iter().zip(firsts) {
            let displacement = match *last {
                Solution::Slide(last) => builder.make(Op::Choose(apart, displacement, last)),
                Solution::Direction(_) => displacement,
            };
            solution.push(Solution::Slide(displacement));
        }
        let size = self.size(&[goal]);
        let reach = self.builder.dot(goal, goal);
        let reach = self.builder.sqrt(reach);
        let most = match size {
            Size::Fixed(size) => self.builder.constant(size),
            Size::Varying(size) => size,
        };
        let reach = self.builder.add(reach, most);
        let near = self.builder.constant(8.0 * tiny);
        let near = self.builder.mul(near, reach);
        let (p, q) = (self.builder.abs(p), self.builder.abs(q));
        let beside = self.builder.max(p, q);
        let on_each_other = self.builder.sub(near, beside);
        let closes = self.builder.make(Op::Choose(apart, one, on_each_other));
        Found {
            solution,
            discriminant: self.builder.abs(det),
            tolerance,
            closes: Some(closes),
            sine: det,
            rounding_square,
            form,
        }
    }

    /// On which side a dyad lies, from a number that is positive on one and negative on the other.
    fn side(&mut self, choice: &Choice, tells: Value) -> Side {
        let positive = choice
            .side
            .unwrap_or_else(|| self.builder.at_start(tells) > 0.0);
        if choice.changes_branch() {
            let sine = if positive { 1.0 } else { -1.0 };
            Side::Carried(self.keep(sine))
        } else {
            Side::Fixed(positive)
        }
    }

    /// The root of a discriminant; what rounding made negative is zero.
    fn root(&mut self, discriminant: Value, choice: &Choice) -> Value {
        let discriminant = if choice.proved {
            discriminant
        } else {
            let zero = self.builder.constant(0.0);
            self.builder.max(discriminant, zero)
        };
        let root = self.builder.sqrt(discriminant);
        self.builder.name(root, "root")
    }

    fn on_side(&mut self, root: Value, side: Side) -> Value {
        match side {
            Side::Fixed(true) => root,
            Side::Fixed(false) => self.builder.neg(root),
            Side::Carried(carried) => {
                let signed = self.builder.copysign(root, carried);
                self.builder.name(signed, "signed_root")
            }
        }
    }

    /// The square of a sine below which rounding hides its sign: where rounding shifts the square of the sine by this part of
    /// epsilon, and not less than what rounding of lengths does to the sine itself.
    fn rounding_square(&mut self, shift: Value, sine: Size) -> Value {
        let epsilon = self.model.precision.epsilon();
        let rounded = self.rounded();
        let least = self.part_of(epsilon, sine);
        let least = self.builder.mul(least, rounded);
        let least = self.builder.mul(least, least);
        let shift_by = self.builder.constant(16.0 * epsilon);
        let shift = self.builder.mul(shift_by, shift);
        self.builder.add(shift, least)
    }

    /// Where pins meet that a dyad of equal lengths joins, any direction closes it: that which it had is kept.
    fn unless_pins_meet(
        &mut self,
        square: Value,
        size: Size,
        direction: Vector,
        last: Solution<Value>,
    ) -> Vector {
        let Solution::Direction(last) = last else {
            return direction;
        };
        let part = 0.5 * TOLERANCE * self.model.precision.epsilon();
        let least = match size {
            Size::Fixed(size) => self.builder.constant((part * size).powi(2)),
            Size::Varying(_) => {
                let least = self.part_of(part, size);
                self.builder.mul(least, least)
            }
        };
        let apart = self.builder.sub(square, least);
        let apart = self.builder.name(apart, "apart");
        [0, 1].map(|part| {
            self.builder
                .make(Op::Choose(apart, direction[part], last[part]))
        })
    }

    /// The lengths at the start of what a loop is made of.
    pub(super) fn size_at_start(&self, sides: &[Vector]) -> f64 {
        let length = |side: &Vector| {
            let [x, y] = side.map(|part| self.builder.at_start(part));
            x.hypot(y)
        };
        sides.iter().map(length).sum()
    }

    /// The tolerance of a difference of squares: so much rounding of twice a size, times a length.
    fn rounding(&mut self, size: Size, length: Value) -> Value {
        let tolerance = self.part_of(2.0 * TOLERANCE * self.model.precision.epsilon(), size);
        self.builder.mul(tolerance, length)
    }
}
