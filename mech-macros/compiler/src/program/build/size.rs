//! How large a loop is, which tolerances are relative to: what it is at the start, unless params change it.

use crate::plan::{Arithmetic, Equation};
use crate::program::builder::SsaBuilder;
use crate::program::node::{Op, Value};
use std::collections::HashMap;

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
        if self.any_varies(&[length]) {
            Size::Varying(length)
        } else {
            Size::Fixed(at_start)
        }
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

    /// One through a size.
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

    /// The sum of these vectors' lengths at the start; where pins all but meet then, what that is most of the time.
    pub(super) fn extent(&self, sides: &[[Value; 2]]) -> f64 {
        /// Wherever links point, a sum of lengths is seldom less than this part of what they reach together.
        const OF_REACH: f64 = 0.125;
        let mut known = HashMap::new();
        let mut length = |side: &[Value; 2]| {
            let [x, y] = side.map(|part| self.magnitude(part, &mut known));
            x.max(y)
        };
        let reach: f64 = sides.iter().map(&mut length).sum();
        self.size_at_start(sides).max(OF_REACH * reach)
    }

    /// How great a value is at most where directions are anything, and all else as great as at the start.
    fn magnitude(&self, value: Value, known: &mut HashMap<Value, f64>) -> f64 {
        if let Some(&found) = known.get(&value) {
            return found;
        }
        let mut of = |value| self.magnitude(value, known);
        let found = if self.is_of_direction(value) {
            1.0
        } else {
            match self.op(value) {
                Op::Neg(a) => of(a),
                Op::Add(a, b) | Op::Sub(a, b) => of(a) + of(b),
                Op::Mul(a, b) => of(a) * of(b),
                _ => self.at_start(value).abs(),
            }
        };
        known.insert(value, found);
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
        let arms = equation
            .rings
            .iter()
            .flat_map(|ring| ring.arms.iter().flatten());
        let offsets = equation.rings.iter().map(|ring| &ring.offset);
        let sides: Vec<[Value; 2]> = arms.chain(offsets).copied().collect();
        match self.size(&sides) {
            Size::Fixed(_) => None,
            Size::Varying(size) => Some(size),
        }
    }
}
