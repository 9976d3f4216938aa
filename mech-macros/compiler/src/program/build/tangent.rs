//! The rate of any value of a program, from the rates of the motors.
//!
//! Values are differentiated operation by operation, but not through loops: the rates of what a loop solves are found from its
//! linear system, and are known here beforehand. Where something turns, its rate is the angular velocity times what is across
//! it: cheaper than the rule of products, and exact.

use crate::model::InputId;
use crate::plan::{Algebra, Arithmetic};
use crate::program::builder::SsaBuilder;
use crate::program::node::{Op, Value};
use std::collections::HashMap;

/// The motion of the inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::program) enum Seed {
    /// They move at the rates and second rates that are given.
    Given,
    /// They move at the rates that are given, and these do not change.
    Coasting,
    /// The input of this number alone moves, at a rate of one: a motor, or a param after them.
    Alone(usize),
}

/// The rates that are known.
#[derive(Debug)]
pub(in crate::program) struct Tangents {
    seed: Seed,
    /// The number of motors among the inputs; params, after them, do not move.
    motors: usize,
    /// Looked up only, never iterated: the program does not depend on its order.
    rates: HashMap<Value, Value>,
    /// The angular velocities of directions, given by cosine and sine.
    angular_velocities: HashMap<[Value; 2], Value>,
    /// Angles between two directions.
    angles: HashMap<Value, [[Value; 2]; 2]>,
}

/// A vector turned by a direction: one of its parts, the direction, the vector, and the other part.
struct Rotation {
    direction: [Value; 2],
    vector: [Value; 2],
    is_x: bool,
    other: Value,
}

impl Seed {
    /// None of them moves.
    pub(in crate::program) const NONE: Self = Self::Alone(usize::MAX);
}

impl Tangents {
    /// Knows nothing but the inputs: so many motors, and params after them.
    pub(in crate::program) fn new(seed: Seed, motors: usize) -> Self {
        Self {
            seed,
            motors,
            rates: HashMap::new(),
            angular_velocities: HashMap::new(),
            angles: HashMap::new(),
        }
    }

    /// The rate of a motor or param.
    fn of_given(&self, ssa: &mut SsaBuilder, given: InputId) -> Value {
        match self.seed {
            Seed::Given | Seed::Coasting => match given.motor(self.motors) {
                Some(motor) => ssa.make(Op::Rate(motor)),
                None => ssa.constant(0.0),
            },
            Seed::Alone(other) => ssa.constant(if given.index() == other { 1.0 } else { 0.0 }),
        }
    }

    /// Notes that a value is the angle from one direction to another.
    pub(super) fn set_angle(&mut self, angle: Value, [from, to]: [[Value; 2]; 2]) {
        self.angles.insert(angle, [from, to]);
    }

    /// Notes the rate of a value that a loop solves. For a value with its sign changed, that of the value itself is noted.
    pub(in crate::program) fn set(&mut self, ssa: &mut SsaBuilder, value: Value, rate: Value) {
        self.rates.insert(value, rate);
        if let Op::Neg(inner) = ssa.op(value) {
            let back = ssa.neg(rate);
            self.rates.insert(inner, back);
        }
    }

    /// Notes the rate of a value, whatever it is made from.
    pub(in crate::program) fn hold(&mut self, value: Value, rate: Value) {
        self.rates.insert(value, rate);
    }

    /// Notes the angular velocity of a direction that a loop solves.
    pub(super) fn set_turning(&mut self, ssa: &mut SsaBuilder, direction: [Value; 2], rate: Value) {
        self.angular_velocities.insert(direction, rate);
        let [cos, sin] = direction;
        let (along, back) = (ssa.mul(rate, cos), ssa.mul(rate, sin));
        let back = ssa.neg(back);
        self.set(ssa, cos, back);
        self.set(ssa, sin, along);
    }

    /// The rate of a value.
    pub(super) fn of(&mut self, ssa: &mut SsaBuilder, value: Value) -> Value {
        if let Some(&known) = self.rates.get(&value) {
            return known;
        }
        let rate = match self.find_rotation(ssa, value) {
            Some(rotation) => self.of_rotation(ssa, &rotation),
            None => self.of_operation(ssa, value),
        };
        self.rates.insert(value, rate);
        rate
    }

    /// The rate of a value, after those of all values that it needs, one by one. Recursion through a long chain would overflow the stack.
    pub(in crate::program) fn of_all_up_to(&mut self, ssa: &mut SsaBuilder, value: Value) -> Value {
        let mut needed = vec![false; value.index() + 1];
        let mut waiting = vec![value];
        while let Some(one) = waiting.pop() {
            if !std::mem::replace(&mut needed[one.index()], true) {
                waiting.extend(ssa.op(one).operands());
            }
        }
        let needed = (0..).map(Value).zip(needed).filter(|(_, needed)| *needed);
        for (one, _) in needed {
            self.of(ssa, one);
        }
        self.of(ssa, value)
    }

    /// The rates of both parts of a vector.
    pub(super) fn of_vector(&mut self, ssa: &mut SsaBuilder, v: [Value; 2]) -> [Value; 2] {
        v.map(|part| self.of(ssa, part))
    }

    fn of_operation(&mut self, ssa: &mut SsaBuilder, value: Value) -> Value {
        let zero = ssa.constant(0.0);
        match ssa.op(value) {
            Op::Input(given) => self.of_given(ssa, given),
            Op::Rate(motor) if self.seed == Seed::Given => ssa.make(Op::Acceleration(motor)),
            Op::Time => ssa.constant(1.0),
            Op::Neg(a) => {
                let a = self.of(ssa, a);
                ssa.neg(a)
            }
            Op::Add(a, b) => {
                let [a, b] = self.of_vector(ssa, [a, b]);
                ssa.add(a, b)
            }
            Op::Sub(a, b) => {
                let [a, b] = self.of_vector(ssa, [a, b]);
                ssa.sub(a, b)
            }
            Op::Mul(a, b) => {
                let [first, second] = self.of_vector(ssa, [a, b]);
                let (first, second) = (ssa.mul(first, b), ssa.mul(a, second));
                ssa.add(first, second)
            }
            Op::Div(a, b) => {
                let [above, below] = self.of_vector(ssa, [a, b]);
                let lost = ssa.mul(value, below);
                let rest = ssa.sub(above, lost);
                part(ssa, rest, b)
            }
            Op::Sqrt(a) => {
                let rate = self.of(ssa, a);
                let two = ssa.constant(2.0);
                let twice = ssa.mul(two, value);
                part(ssa, rate, twice)
            }
            Op::Sin(angle) => {
                let (rate, cos) = (self.of(ssa, angle), ssa.make(Op::Cos(angle)));
                ssa.mul(rate, cos)
            }
            Op::Cos(angle) => {
                let (rate, sin) = (self.of(ssa, angle), ssa.make(Op::Sin(angle)));
                let product = ssa.mul(rate, sin);
                ssa.neg(product)
            }
            Op::Exp(a) => {
                let rate = self.of(ssa, a);
                ssa.mul(rate, value)
            }
            Op::Stairs(stairs, place, share) => {
                let rate = self.of(ssa, place);
                let slope = ssa.make(Op::Stairs(stairs.slope(), place, share));
                let (share, product) = (ssa.constant(share.get()), ssa.mul(slope, rate));
                ssa.div(product, share)
            }
            Op::Abs(a) => {
                let (rate, one) = (self.of(ssa, a), ssa.constant(1.0));
                let sign = ssa.copysign(one, a);
                ssa.mul(sign, rate)
            }
            Op::CopySign(size, sign) => {
                // Sizes are not negative: they are roots.
                let (rate, one) = (self.of(ssa, size), ssa.constant(1.0));
                let sign = ssa.copysign(one, sign);
                ssa.mul(sign, rate)
            }
            Op::Max(a, b) => {
                let [first, second] = self.of_vector(ssa, [a, b]);
                let test = ssa.sub(a, b);
                ssa.make(Op::Choose(test, first, second))
            }
            Op::Choose(test, a, b) => {
                let [first, second] = self.of_vector(ssa, [a, b]);
                ssa.make(Op::Choose(test, first, second))
            }
            Op::Atan2(sin, cos) => match self.angles.get(&value).copied() {
                Some([from, to]) => {
                    let [from, to] =
                        [from, to].map(|direction| self.angular_velocity(ssa, direction));
                    ssa.sub(to, from)
                }
                None => self.of_direction(ssa, [cos, sin]),
            },
            Op::Constant(_)
            | Op::Turns(_)
            | Op::PartOfTurns(..)
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

    fn of_rotation(&mut self, ssa: &mut SsaBuilder, rotation: &Rotation) -> Value {
        let Rotation { direction: [cos, sin], vector, is_x, other } = *rotation;
        let speed = self.angular_velocity(ssa, [cos, sin]);
        let across = ssa.mul(speed, other);
        let [p, q] = self.of_vector(ssa, vector);
        if is_x {
            let (cp, sq) = (ssa.mul(cos, p), ssa.mul(sin, q));
            let own = ssa.sub(cp, sq);
            ssa.sub(own, across)
        } else {
            let (sp, cq) = (ssa.mul(sin, p), ssa.mul(cos, q));
            let own = ssa.add(sp, cq);
            ssa.add(own, across)
        }
    }

    /// The angular velocity of a direction.
    pub(in crate::program) fn angular_velocity(
        &mut self,
        ssa: &mut SsaBuilder,
        direction: [Value; 2],
    ) -> Value {
        if let Some(&known) = self.angular_velocities.get(&direction) {
            return known;
        }
        let [cos, sin] = direction;
        let speed = match (ssa.op(cos), ssa.op(sin)) {
            (Op::Cos(a), Op::Sin(b)) if a == b => self.of(ssa, a),
            (_, Op::Neg(back)) if self.is_direction(ssa, [cos, back]) => {
                let speed = self.angular_velocity(ssa, [cos, back]);
                ssa.neg(speed)
            }
            _ => match self.find_rotation(ssa, cos) {
                Some(rotation) if rotation.is_x && rotation.other == sin => {
                    let outer = self.angular_velocity(ssa, rotation.direction);
                    let inner = self.angular_velocity(ssa, rotation.vector);
                    ssa.add(outer, inner)
                }
                _ => {
                    let rate = self.of_vector(ssa, direction);
                    ssa.cross(direction, rate)
                }
            },
        };
        self.angular_velocities.insert(direction, speed);
        speed
    }

    /// The angular velocity of a vector of any length.
    fn of_direction(&mut self, ssa: &mut SsaBuilder, v: [Value; 2]) -> Value {
        let rate = self.of_vector(ssa, v);
        let across = ssa.cross(v, rate);
        if ssa.number(across) == Some(0.0) {
            return across;
        }
        let square = ssa.dot(v, v);
        ssa.div(across, square)
    }

    fn is_direction(&self, ssa: &SsaBuilder, direction: [Value; 2]) -> bool {
        let motor = match direction.map(|part| ssa.op(part)) {
            [Op::Cos(a), Op::Sin(b)] => a == b,
            _ => false,
        };
        motor || self.angular_velocities.contains_key(&direction)
    }

    /// Finds the rotation that makes a value, a coordinate of a vector that a direction turns; none if it is made otherwise.
    fn find_rotation(&self, ssa: &SsaBuilder, value: Value) -> Option<Rotation> {
        let (first, second, is_x) = match ssa.op(value) {
            Op::Sub(a, b) => (a, b, true),
            Op::Add(a, b) => (a, b, false),
            _ => return None,
        };
        let (Op::Mul(a, b), Op::Mul(c, d)) = (ssa.op(first), ssa.op(second)) else {
            return None;
        };
        let pairs = [([a, b], [c, d]), ([b, a], [c, d]), ([a, b], [d, c]), ([b, a], [d, c])];
        let swapped = pairs.map(|(first, second)| (second, first));
        let candidates = pairs.into_iter().chain(swapped.into_iter().filter(|_| !is_x));
        for ([e, p], [f, q]) in candidates {
            // The cosine turns p into x, and q into y.
            let (direction, vector) = if is_x { ([e, f], [p, q]) } else { ([f, e], [p, q]) };
            if !self.is_direction(ssa, direction) {
                continue;
            }
            let [cos, sin] = direction;
            let product = |a: Value, b: Value| ssa.find(Op::Mul(a.min(b), a.max(b)));
            let other = if is_x {
                let (a, b) = (product(sin, vector[0])?, product(cos, vector[1])?);
                ssa.find(Op::Add(a.min(b), a.max(b)))
            } else {
                let (a, b) = (product(cos, vector[0])?, product(sin, vector[1])?);
                ssa.find(Op::Sub(a, b))
            };
            if let Some(other) = other {
                return Some(Rotation { direction, vector, is_x, other });
            }
        }
        None
    }
}

/// A quotient; a rate of zero stays zero without a division.
fn part(ssa: &mut SsaBuilder, a: Value, b: Value) -> Value {
    if ssa.number(a) == Some(0.0) {
        return a;
    }
    ssa.div(a, b)
}
