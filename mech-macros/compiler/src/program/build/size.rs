//! The size of a loop, to which tolerances are relative: that at the start, unless params change it.

use crate::plan::{Arithmetic, Equation};
use crate::program::builder::SsaBuilder;
use crate::program::node::{Op, Value};
use std::collections::HashMap;

/// The magnitudes of vectors and numbers that were found.
#[derive(Debug, Default)]
struct Known {
    vectors: HashMap<[Value; 2], f64>,
    values: HashMap<Value, f64>,
}

/// A length that tolerances are relative to.
#[derive(Clone, Copy, Debug)]
pub(super) enum Size {
    /// Its value at the start.
    Fixed(f64),
    /// Its present value: a param has a part in it.
    Varying(Value),
}

impl Size {
    /// Whether a param has a part in it.
    pub(super) fn varies(self) -> bool {
        matches!(self, Self::Varying(_))
    }
}

impl SsaBuilder {
    /// A length, if a param has a part in it; else what it is at the start.
    pub(super) fn size_or(&self, length: Value, at_start: f64) -> Size {
        if self.any_varies(&[length]) { Size::Varying(length) } else { Size::Fixed(at_start) }
    }

    /// A part of a size.
    pub(super) fn part_of(&mut self, part: f64, size: Size) -> Value {
        match size {
            Size::Fixed(size) => self.constant(part * size),
            Size::Varying(size) => {
                let part = self.constant(part);
                self.mul(part, size)
            }
        }
    }

    /// The inverse of a size.
    pub(super) fn inverse_of(&mut self, size: Size) -> Value {
        match size {
            Size::Fixed(size) => self.constant(1.0 / size),
            Size::Varying(size) => {
                let one = self.constant(1.0);
                self.div(one, size)
            }
        }
    }

    /// Whether a param has a part in one of these.
    pub(super) fn any_varies(&self, values: &[Value]) -> bool {
        values.iter().any(|&value| self.varies(value))
    }

    /// The sum of these vectors' lengths at the start.
    pub(super) fn size_at_start(&self, sides: &[[Value; 2]]) -> f64 {
        let length = |side: &[Value; 2]| {
            let [x, y] = side.map(|part| self.at_start(part));
            x.hypot(y)
        };
        sides.iter().map(length).sum()
    }

    /// The sum of the lengths of these vectors at the start. Where pins nearly meet at the start, that would be too small: then a part of
    /// what the vectors reach.
    pub(super) fn extent(&self, sides: &[[Value; 2]]) -> f64 {
        /// Wherever links point, a sum of lengths is seldom less than this part of what they reach together.
        const OF_REACH: f64 = 1.0 / 64.0;
        let mut known = Known::default();
        let lengths = sides.iter().map(|side| self.radius(*side, &mut known));
        let reach: f64 = lengths.sum();
        self.size_at_start(sides).max(OF_REACH * reach)
    }

    /// The greatest length of a vector, with directions at any angle and all else as at the start. A bound for each coordinate alone
    /// would grow with every link that turns it.
    fn radius(&self, vector: [Value; 2], known: &mut Known) -> f64 {
        if let Some(&found) = known.vectors.get(&vector) {
            return found;
        }
        let [x, y] = vector;
        let found = if self.are_direction(vector) {
            1.0
        } else if let Some(before) = self.turned(vector) {
            self.radius(before, known)
        } else {
            match (self.op(x), self.op(y)) {
                (Op::Add(a, b) | Op::Sub(a, b), Op::Add(c, d) | Op::Sub(c, d)) => {
                    self.radius([a, c], known) + self.radius([b, d], known)
                }
                (Op::Neg(a), Op::Neg(b)) => self.radius([a, b], known),
                (Op::Mul(a, b), Op::Mul(c, d)) if a == c || b == d => {
                    let (length, parts) = if a == c { (a, [b, d]) } else { (b, [a, c]) };
                    self.magnitude(length, known) * self.radius(parts, known)
                }
                _ => self.magnitude(x, known).hypot(self.magnitude(y, known)),
            }
        };
        known.vectors.insert(vector, found);
        found
    }

    /// The vector that a direction turns to become this one.
    fn turned(&self, [x, y]: [Value; 2]) -> Option<[Value; 2]> {
        let [[one, other], of_y] = [self.products(x)?, self.products(y)?];
        let ways = |[a, b]: [Value; 2]| [[a, b], [b, a]];
        ways(one).into_iter().find_map(|[cos, u]| {
            let beside = |way: &[Value; 2]| self.are_direction([cos, way[0]]);
            let [sin, v] = ways(other).into_iter().find(beside)?;
            let is = |product: [Value; 2], of: [Value; 2]| ways(product).contains(&of);
            let [first, second] = of_y;
            let is_turned = is(first, [sin, u]) && is(second, [cos, v])
                || is(first, [cos, v]) && is(second, [sin, u]);
            is_turned.then_some([u, v])
        })
    }

    /// The two products whose sum or difference a value is: their factors.
    fn products(&self, value: Value) -> Option<[[Value; 2]; 2]> {
        let (Op::Add(a, b) | Op::Sub(a, b)) = self.op(value) else {
            return None;
        };
        match (self.op(a), self.op(b)) {
            (Op::Mul(a, b), Op::Mul(c, d)) => Some([[a, b], [c, d]]),
            _ => None,
        }
    }

    /// Whether a value is a constant, or a part of a direction.
    fn is_part(&self, value: Value) -> bool {
        matches!(self.op(value), Op::Constant(_)) || self.is_of_direction(value)
    }

    /// The greatest size of a value, with directions at any angle and all else as at the start.
    fn magnitude(&self, value: Value, known: &mut Known) -> f64 {
        if let Some(&found) = known.values.get(&value) {
            return found;
        }
        let mut of = |value| self.magnitude(value, known);
        let found = match self.op(value) {
            Op::Constant(_) => self.at_start(value).abs(),
            _ if self.is_of_direction(value) => 1.0,
            Op::Neg(a) => of(a),
            Op::Add(a, b) | Op::Sub(a, b) => of(a) + of(b),
            // The unknown of a loop is a quotient: the magnitudes of its parts tell nothing about it.
            Op::Mul(a, b) if self.is_part(a) || self.is_part(b) => of(a) * of(b),
            _ => self.at_start(value).abs(),
        };
        known.values.insert(value, found);
        found
    }

    /// The sum of these vectors' lengths.
    pub(super) fn size(&mut self, sides: &[[Value; 2]]) -> Size {
        if !self.any_varies(sides.as_flattened()) {
            return Size::Fixed(self.extent(sides));
        }
        let mut size = self.constant(0.0);
        for side in sides {
            let length = self.about(side);
            size = self.add(size, length);
        }
        Size::Varying(self.name(size, "size"))
    }

    /// The length of a vector without a root: the sum of its numbers' sizes.
    pub(super) fn about(&mut self, vector: &[Value]) -> Value {
        let mut sum = self.constant(0.0);
        for &part in vector {
            let part = self.abs(part);
            sum = self.add(sum, part);
        }
        sum
    }

    /// The length of the vectors round a loop, if params have a part in it.
    pub(super) fn varying_extent(&mut self, equation: &Equation<Value>) -> Option<Value> {
        let arms = equation.rings.iter().flat_map(|ring| ring.arms.iter().flatten());
        let offsets = equation.rings.iter().map(|ring| &ring.offset);
        let sides: Vec<[Value; 2]> = arms.chain(offsets).copied().collect();
        match self.size(&sides) {
            Size::Fixed(_) => None,
            Size::Varying(size) => Some(size),
        }
    }
}
