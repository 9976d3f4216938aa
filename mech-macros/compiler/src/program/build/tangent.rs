//! The rate of any value of a program, from the rates of the motors.
//!
//! Values are differentiated operation by operation, but not through loops: the rates of what a loop solves are found from its
//! linear system, and are known here beforehand. Where something turns, its rate is the angular velocity times what is across
//! it: cheaper than the rule of products, and exact.

use crate::plan::Algebra;
use crate::program::builder::Builder;
use crate::program::node::{Op, Value};
use std::collections::HashMap;

/// What the motors do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::program) enum Seed {
    /// They move at the rates and second rates that are given.
    Given,
    /// They move at the rates that are given, and these do not change.
    Coasting,
    /// What is given under this number alone moves, at a rate of one: a motor, or a param after them.
    Alone(usize),
}

/// What is known about rates.
#[derive(Debug)]
pub(in crate::program) struct Tangents {
    seed: Seed,
    /// How many of what is given are motors; params, after them, rest.
    motors: usize,
    /// Looked up only, never iterated: the program does not depend on its order.
    rates: HashMap<Value, Value>,
    /// The angular velocities of directions, given by cosine and sine.
    turning: HashMap<[Value; 2], Value>,
    /// Angles between two directions.
    angles: HashMap<Value, [[Value; 2]; 2]>,
}

/// A vector turned by a direction: one of its parts, the direction, the vector, and the other part.
struct Turned {
    direction: [Value; 2],
    vector: [Value; 2],
    is_x: bool,
    other: Value,
}

impl Tangents {
    /// Nothing but what is given: so many motors, and params after them.
    pub(in crate::program) fn new(seed: Seed, motors: usize) -> Self {
        Self {
            seed,
            motors,
            rates: HashMap::new(),
            turning: HashMap::new(),
            angles: HashMap::new(),
        }
    }

    /// The rate of a motor or param.
    fn of_given(&self, builder: &mut Builder, given: usize) -> Value {
        match self.seed {
            Seed::Given | Seed::Coasting if given < self.motors => builder.make(Op::Rate(given)),
            Seed::Given | Seed::Coasting => builder.constant(0.0),
            Seed::Alone(other) => builder.constant(if given == other { 1.0 } else { 0.0 }),
        }
    }

    /// Notes that a value is the angle from one direction to another.
    pub(super) fn is_angle(&mut self, angle: Value, [from, to]: [[Value; 2]; 2]) {
        self.angles.insert(angle, [from, to]);
    }

    /// Notes the rate of a value that a loop solves. What is made from a value with its sign turned is made from the value itself.
    pub(super) fn set(&mut self, builder: &mut Builder, value: Value, rate: Value) {
        self.rates.insert(value, rate);
        if let Op::Neg(inner) = builder.op(value) {
            let back = builder.neg(rate);
            self.rates.insert(inner, back);
        }
    }

    /// Notes the angular velocity of a direction that a loop solves.
    pub(super) fn set_turning(
        &mut self,
        builder: &mut Builder,
        direction: [Value; 2],
        rate: Value,
    ) {
        self.turning.insert(direction, rate);
        let [cos, sin] = direction;
        let (along, back) = (builder.mul(rate, cos), builder.mul(rate, sin));
        let back = builder.neg(back);
        self.set(builder, cos, back);
        self.set(builder, sin, along);
    }

    /// The rate of a value.
    pub(super) fn of(&mut self, builder: &mut Builder, value: Value) -> Value {
        if let Some(&known) = self.rates.get(&value) {
            return known;
        }
        let rate = match self.turned(builder, value) {
            Some(turned) => self.of_turned(builder, &turned),
            None => self.of_operation(builder, value),
        };
        self.rates.insert(value, rate);
        rate
    }

    /// The rate of a value at the end of a long chain: one after the other from its beginning, as the stack holds no long chain.
    pub(in crate::program) fn of_all_up_to(
        &mut self,
        builder: &mut Builder,
        value: Value,
    ) -> Value {
        let mut needed = vec![false; value.index() + 1];
        let mut waiting = vec![value];
        while let Some(one) = waiting.pop() {
            if !std::mem::replace(&mut needed[one.index()], true) {
                waiting.extend(builder.op(one).operands());
            }
        }
        let needed = (0..).map(Value).zip(needed).filter(|(_, needed)| *needed);
        for (one, _) in needed {
            self.of(builder, one);
        }
        self.of(builder, value)
    }

    /// The rates of both parts of a vector.
    pub(super) fn of_vector(&mut self, builder: &mut Builder, v: [Value; 2]) -> [Value; 2] {
        v.map(|part| self.of(builder, part))
    }

    fn of_operation(&mut self, builder: &mut Builder, value: Value) -> Value {
        let zero = builder.constant(0.0);
        match builder.op(value) {
            Op::Motor(given) => self.of_given(builder, given),
            Op::Rate(motor) if self.seed == Seed::Given => builder.make(Op::Acceleration(motor)),
            Op::Time => builder.constant(1.0),
            Op::Neg(a) => {
                let a = self.of(builder, a);
                builder.neg(a)
            }
            Op::Add(a, b) => {
                let [a, b] = self.of_vector(builder, [a, b]);
                builder.add(a, b)
            }
            Op::Sub(a, b) => {
                let [a, b] = self.of_vector(builder, [a, b]);
                builder.sub(a, b)
            }
            Op::Mul(a, b) => {
                let [first, second] = self.of_vector(builder, [a, b]);
                let (first, second) = (builder.mul(first, b), builder.mul(a, second));
                builder.add(first, second)
            }
            Op::Div(a, b) => {
                let [above, below] = self.of_vector(builder, [a, b]);
                let lost = builder.mul(value, below);
                let rest = builder.sub(above, lost);
                part(builder, rest, b)
            }
            Op::Sqrt(a) => {
                let rate = self.of(builder, a);
                let two = builder.constant(2.0);
                let twice = builder.mul(two, value);
                part(builder, rate, twice)
            }
            Op::Sin(angle) => {
                let (rate, cos) = (self.of(builder, angle), builder.make(Op::Cos(angle)));
                builder.mul(rate, cos)
            }
            Op::Cos(angle) => {
                let (rate, sin) = (self.of(builder, angle), builder.make(Op::Sin(angle)));
                let product = builder.mul(rate, sin);
                builder.neg(product)
            }
            Op::Exp(a) => {
                let rate = self.of(builder, a);
                builder.mul(rate, value)
            }
            Op::Abs(a) => {
                let (rate, one) = (self.of(builder, a), builder.constant(1.0));
                let sign = builder.copysign(one, a);
                builder.mul(sign, rate)
            }
            Op::CopySign(size, sign) => {
                // Sizes are not negative: they are roots.
                let (rate, one) = (self.of(builder, size), builder.constant(1.0));
                let sign = builder.copysign(one, sign);
                builder.mul(sign, rate)
            }
            Op::Max(a, b) => {
                let [first, second] = self.of_vector(builder, [a, b]);
                let test = builder.sub(a, b);
                builder.make(Op::Choose(test, first, second))
            }
            Op::Choose(test, a, b) => {
                let [first, second] = self.of_vector(builder, [a, b]);
                builder.make(Op::Choose(test, first, second))
            }
            Op::Atan2(sin, cos) => match self.angles.get(&value).copied() {
                Some([from, to]) => {
                    let [from, to] = [from, to].map(|direction| self.turning(builder, direction));
                    builder.sub(to, from)
                }
                None => self.of_direction(builder, [cos, sin]),
            },
            Op::Constant(_)
            | Op::Turns(_)
            | Op::Turned(..)
            | Op::Last(_)
            | Op::Round(_)
            | Op::Rate(_)
            | Op::Acceleration(_)
            | Op::Load(_)
            | Op::Unknown(..)
            | Op::Solved(..)
            | Op::Dense(..)
            | Op::Linear(..) => zero,
        }
    }

    fn of_turned(&mut self, builder: &mut Builder, turned: &Turned) -> Value {
        let Turned {
            direction: [cos, sin],
            vector,
            is_x,
            other,
        } = *turned;
        let speed = self.turning(builder, [cos, sin]);
        let across = builder.mul(speed, other);
        let [p, q] = self.of_vector(builder, vector);
        if is_x {
            let (cp, sq) = (builder.mul(cos, p), builder.mul(sin, q));
            let own = builder.sub(cp, sq);
            builder.sub(own, across)
        } else {
            let (sp, cq) = (builder.mul(sin, p), builder.mul(cos, q));
            let own = builder.add(sp, cq);
            builder.add(own, across)
        }
    }

    /// The angular velocity of a direction.
    pub(super) fn turning(&mut self, builder: &mut Builder, direction: [Value; 2]) -> Value {
        if let Some(&known) = self.turning.get(&direction) {
            return known;
        }
        let [cos, sin] = direction;
        let speed = match (builder.op(cos), builder.op(sin)) {
            (Op::Cos(a), Op::Sin(b)) if a == b => self.of(builder, a),
            (_, Op::Neg(back)) if self.is_direction(builder, [cos, back]) => {
                let speed = self.turning(builder, [cos, back]);
                builder.neg(speed)
            }
            _ => match self.turned(builder, cos) {
                Some(turned) if turned.is_x && turned.other == sin => {
                    let outer = self.turning(builder, turned.direction);
                    let inner = self.turning(builder, turned.vector);
                    builder.add(outer, inner)
                }
                _ => {
                    let rate = self.of_vector(builder, direction);
                    builder.cross(direction, rate)
                }
            },
        };
        self.turning.insert(direction, speed);
        speed
    }

    /// The angular velocity of a vector of any length.
    fn of_direction(&mut self, builder: &mut Builder, v: [Value; 2]) -> Value {
        let rate = self.of_vector(builder, v);
        let across = builder.cross(v, rate);
        if builder.number(across) == Some(0.0) {
            return across;
        }
        let square = builder.dot(v, v);
        builder.div(across, square)
    }

    fn is_direction(&self, builder: &Builder, direction: [Value; 2]) -> bool {
        let motor = match direction.map(|part| builder.op(part)) {
            [Op::Cos(a), Op::Sin(b)] => a == b,
            _ => false,
        };
        motor || self.turning.contains_key(&direction)
    }

    /// A value as a part of a vector that is turned by a direction, if it is made so.
    fn turned(&self, builder: &Builder, value: Value) -> Option<Turned> {
        let (first, second, is_x) = match builder.op(value) {
            Op::Sub(a, b) => (a, b, true),
            Op::Add(a, b) => (a, b, false),
            _ => return None,
        };
        let (Op::Mul(a, b), Op::Mul(c, d)) = (builder.op(first), builder.op(second)) else {
            return None;
        };
        let pairs = [
            ([a, b], [c, d]),
            ([b, a], [c, d]),
            ([a, b], [d, c]),
            ([b, a], [d, c]),
        ];
        let swapped = pairs.map(|(first, second)| (second, first));
        let candidates = pairs
            .into_iter()
            .chain(swapped.into_iter().filter(|_| !is_x));
        for ([e, p], [f, q]) in candidates {
            // The cosine turns p into x, and q into y.
            let (direction, vector) = if is_x {
                ([e, f], [p, q])
            } else {
                ([f, e], [p, q])
            };
            if !self.is_direction(builder, direction) {
                continue;
            }
            let [cos, sin] = direction;
            let product = |a: Value, b: Value| builder.find(Op::Mul(a.min(b), a.max(b)));
            let other = if is_x {
                let (a, b) = (product(sin, vector[0])?, product(cos, vector[1])?);
                builder.find(Op::Add(a.min(b), a.max(b)))
            } else {
                let (a, b) = (product(cos, vector[0])?, product(sin, vector[1])?);
                builder.find(Op::Sub(a, b))
            };
            if let Some(other) = other {
                return Some(Turned {
                    direction,
                    vector,
                    is_x,
                    other,
                });
            }
        }
        None
    }
}

/// One value through another; what rests does so whatever it is divided by.
fn part(builder: &mut Builder, a: Value, b: Value) -> Value {
    if builder.number(a) == Some(0.0) {
        return a;
    }
    builder.div(a, b)
}
