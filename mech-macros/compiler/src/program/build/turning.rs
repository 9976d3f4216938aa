//! Directions: how they are turned and stay at length one, and the angles between them.

use crate::plan::{Algebra, Arithmetic, Solution};
use crate::program::builder::SsaBuilder;
use crate::program::node::{Op, Value};

impl SsaBuilder {
    /// Notes by which factors an angle follows motors and the angles that drive gears: its rounding grows by these.
    pub(super) fn note_gains(&mut self, angle: Value) {
        let mut parts = Vec::new();
        self.parts_of(angle, 1.0, &mut parts);
        for (driver, part) in parts {
            let gain = self.gains.entry(driver).or_insert(1.0);
            *gain = gain.max(part.abs());
        }
    }

    /// The values of which this value is a sum with constant parts, constants left out.
    fn parts_of(&self, value: Value, part: f64, parts: &mut Vec<(Value, f64)>) {
        match self.op(value) {
            Op::Constant(_) | Op::PartOfTurns(..) => {}
            Op::Neg(a) => self.parts_of(a, -part, parts),
            Op::Add(a, b) => {
                self.parts_of(a, part, parts);
                self.parts_of(b, part, parts);
            }
            Op::Sub(a, b) => {
                self.parts_of(a, part, parts);
                self.parts_of(b, -part, parts);
            }
            Op::Mul(a, b) => match (self.number(a), self.number(b)) {
                (Some(number), _) => self.parts_of(b, part * number, parts),
                (_, Some(number)) => self.parts_of(a, part * number, parts),
                _ => parts.push((value, part)),
            },
            _ => parts.push((value, part)),
        }
    }

    /// One step towards length one, so that rounding never adds up.
    pub(super) fn normalise(&mut self, v: [Value; 2], name: &str) -> [Value; 2] {
        let square = self.dot(v, v);
        let (half, three) = (self.constant(0.5), self.constant(1.5));
        let half = self.mul(half, square);
        let factor = self.sub(three, half);
        let factor = self.name(factor, format!("{name}_scale"));
        self.scale(factor, v)
    }

    /// A margin, unless a direction is not of length one: that of a link which a param made so short that rounding hides it.
    pub(super) fn unless_stretched(
        &mut self,
        margin: Value,
        solution: &[Solution<Value>],
    ) -> Value {
        /// A direction whose square is off by more than this, after one step towards length one, was no direction.
        const STRETCH: f64 = 1.0 / 1024.0;
        let builder = self;
        solution.iter().fold(margin, |margin, unknown| {
            let Solution::Direction(direction) = *unknown else {
                return margin;
            };
            let (one, most) = (builder.constant(1.0), builder.constant(STRETCH));
            let square = builder.dot(direction, direction);
            let stretch = builder.sub(square, one);
            let stretch = builder.abs(stretch);
            let room = builder.sub(most, stretch);
            let room = builder.name(room, "room");
            builder.make(Op::Choose(room, margin, room))
        })
    }

    /// A direction turned by a small angle, to third order: without a division.
    pub(super) fn rotate_slightly(
        &mut self,
        direction: [Value; 2],
        angle: Value,
        name: &str,
    ) -> [Value; 2] {
        let builder = self;
        let (half, one) = (builder.constant(0.5), builder.constant(1.0));
        let square = builder.mul(angle, angle);
        let half = builder.mul(half, square);
        // (1 − a²/2, a) has the length √(1 + e) with e = a⁴/4, which would stretch the link.
        let e = builder.mul(half, half);
        let (b, c) = (builder.constant(0.5), builder.constant(0.375));
        let c = builder.mul(c, e);
        let factor = builder.sub(b, c);
        let too_long = builder.mul(factor, e);
        let scale = builder.sub(one, too_long);
        let cos = builder.sub(one, half);
        let turn = builder.scale(scale, [cos, angle]);
        let turn = builder.name_direction(turn, &format!("{name}_turn"));
        builder.rotate(direction, turn)
    }

    /// A direction turned by a small angle, by the rational map that keeps its length (Cayley's).
    pub(super) fn rotate_by(
        &mut self,
        direction: [Value; 2],
        angle: Value,
        name: &str,
    ) -> [Value; 2] {
        let builder = self;
        let (half, one) = (builder.constant(0.5), builder.constant(1.0));
        let tangent = builder.mul(half, angle);
        let tangent = builder.name(tangent, format!("{name}_tangent"));
        let square = builder.mul(tangent, tangent);
        let sum = builder.add(one, square);
        let two = builder.constant(2.0);
        // cos = 2/(1 + t²) − 1 and sin = t · 2/(1 + t²), with t the tangent of half the angle.
        let factor = builder.div(two, sum);
        let factor = builder.name(factor, format!("{name}_factor"));
        let turn = [builder.sub(factor, one), builder.mul(tangent, factor)];
        let turn = builder.name_direction(turn, &format!("{name}_turn"));
        builder.rotate(direction, turn)
    }

    /// The angle from one direction to another, between −π and π.
    pub(super) fn angle_between(&mut self, [from, to]: [[Value; 2]; 2]) -> Value {
        let (sin, cos) = (self.cross(from, to), self.dot(from, to));
        self.make(Op::Atan2(sin, cos))
    }

    /// The first of two unknowns of one kind if a number is not negative, else the second.
    pub(super) fn choose(
        &mut self,
        test: Value,
        a: Solution<Value>,
        b: Solution<Value>,
    ) -> Solution<Value> {
        let mut choose = |a, b| self.make(Op::Choose(test, a, b));
        match (a, b) {
            (Solution::Direction([a, b]), Solution::Direction([c, d])) => {
                Solution::Direction([choose(a, c), choose(b, d)])
            }
            (Solution::Slide(a), Solution::Slide(b)) => Solution::Slide(choose(a, b)),
            (a, _) => a,
        }
    }
}
