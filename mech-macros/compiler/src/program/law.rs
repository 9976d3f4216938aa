//! A law as values of a program.

use super::builder::Builder;
use super::node::{Op, Value};
use crate::model::{Extreme, Function, Law, Term, TermId};
use crate::plan::Algebra;

impl Builder {
    /// A law of a value.
    pub(super) fn law(&mut self, law: &Law, variable: Value) -> Value {
        let mut values: Vec<Value> = Vec::with_capacity(law.terms().len());
        for term in law.terms() {
            // A term is made from earlier ones.
            let get = |id: TermId| values[id.index()];
            let value = match *term {
                Term::Variable => variable,
                Term::Number(number) => self.constant(number),
                Term::Negative(a) => self.neg(get(a)),
                Term::Sum(a, b) => self.add(get(a), get(b)),
                Term::Difference(a, b) => self.sub(get(a), get(b)),
                Term::Product(a, b) => self.mul(get(a), get(b)),
                Term::Quotient(a, b) => self.div(get(a), get(b)),
                Term::Of(function, a) => self.function(function, get(a)),
                Term::Extreme(extreme, a, b) => self.extreme(extreme, [get(a), get(b)]),
            };
            values.push(value);
        }
        match values.last() {
            Some(last) => *last,
            // Without a term it is zero.
            None => self.constant(0.0),
        }
    }

    fn function(&mut self, function: Function, a: Value) -> Value {
        match function {
            Function::Sqrt => self.sqrt(a),
            Function::Sin => self.make(Op::Sin(a)),
            Function::Cos => self.make(Op::Cos(a)),
            Function::Tan => {
                let (sin, cos) = (self.make(Op::Sin(a)), self.make(Op::Cos(a)));
                self.div(sin, cos)
            }
            Function::Atan => {
                let one = self.constant(1.0);
                self.make(Op::Atan2(a, one))
            }
            Function::Exp => self.make(Op::Exp(a)),
            Function::Abs => self.abs(a),
        }
    }

    /// The lesser or greater of two, so that what is not a number does not go unnoticed, and a constant comes out as it is: it,
    /// and how much farther the other goes, if it does.
    fn extreme(&mut self, extreme: Extreme, [a, b]: [Value; 2]) -> Value {
        let [base, other] = if self.number(a).is_some() {
            [a, b]
        } else {
            [b, a]
        };
        let zero = self.constant(0.0);
        match extreme {
            Extreme::Greatest => {
                let farther = self.sub(other, base);
                let farther = self.max(zero, farther);
                self.add(base, farther)
            }
            Extreme::Least => {
                let farther = self.sub(base, other);
                let farther = self.max(zero, farther);
                self.sub(base, farther)
            }
        }
    }
}
