//! The linear system of a loop, solved by explicit formulas.

use crate::plan::{Algebra, Arithmetic};
use crate::program::builder::SsaBuilder;
use crate::program::node::{BlockId, Op, Value};

impl SsaBuilder {
    /// The steps of the unknowns that close the gap to first order, and the determinant.
    pub(super) fn solve_linear(
        &mut self,
        block: BlockId,
        columns: &[Vec<Value>],
        gap: &[Value],
    ) -> (Vec<Value>, Value) {
        match (columns, gap) {
            ([a, b], &[x, y]) => {
                let (a, b, gap) = ([a[0], a[1]], [b[0], b[1]], [x, y]);
                let det = self.cross(a, b);
                let (p, q) = (self.cross(b, gap), self.cross(gap, a));
                let one = self.constant(1.0);
                let inverse = self.div(one, det);
                let inverse = self.name(inverse, "inverse");
                (vec![self.mul(p, inverse), self.mul(q, inverse)], det)
            }
            ([a, b, c], [_, _, _]) => self.cramer([a, b, c], gap),
            // More equations than unknowns, where joints are redundant: as good as possible.
            ([a], &[x, y]) => {
                let a = [a[0], a[1]];
                let square = self.dot(a, a);
                let along = self.dot(a, [x, y]);
                let along = self.neg(along);
                (vec![self.div(along, square)], square)
            }
            _ => {
                let dense = |builder: &mut SsaBuilder, index| builder.make(Op::Dense(block, index));
                let steps = (0..columns.len()).map(|index| {
                    let step = dense(self, index);
                    self.name(step, "step")
                });
                (steps.collect(), dense(self, columns.len()))
            }
        }
    }

    /// Three steps and the determinant, by Cramer's rule.
    fn cramer(&mut self, [a, b, c]: [&Vec<Value>; 3], gap: &[Value]) -> (Vec<Value>, Value) {
        let [a, b, c, gap] = [a, b, c, gap].map(|column| [column[0], column[1], column[2]]);
        let det = self.triple(a, b, c);
        let parts = [self.triple(gap, b, c), self.triple(a, gap, c), self.triple(a, b, gap)];
        let steps = parts.map(|part| {
            let part = self.neg(part);
            self.div(part, det)
        });
        (steps.to_vec(), det)
    }

    /// Adds to each of some sums.
    pub(super) fn add_to(&mut self, sums: &mut [Value], parts: impl IntoIterator<Item = Value>) {
        for (sum, part) in sums.iter_mut().zip(parts) {
            *sum = self.add(*sum, part);
        }
    }

    /// The determinant of three columns.
    fn triple(&mut self, a: [Value; 3], b: [Value; 3], c: [Value; 3]) -> Value {
        let builder = self;
        let minors =
            [(1, 2), (2, 0), (0, 1)].map(|(i, j)| builder.cross([b[i], b[j]], [c[i], c[j]]));
        let [x, y, z] = [0, 1, 2].map(|row| builder.mul(a[row], minors[row]));
        let sum = builder.add(x, y);
        builder.add(sum, z)
    }
}
