//! A law as a program of its own, with its first two derivatives.

use super::build::{Seed, Tangents};
use super::builder::SsaBuilder;
use super::node::{Op, Value};
use super::{Ssa, timing};
use crate::model::{InputId, Law, Model, Precision};

/// A law and its derivatives by its variable.
#[derive(Clone, Debug)]
pub(super) struct LawProgram {
    ssa: Ssa,
    /// The number of motors, after which params are given.
    motors: usize,
    values: [Value; 3],
}

impl LawProgram {
    /// The program of a law of this mechanism.
    pub(super) fn new(model: &Model, law: &Law) -> Self {
        let mut ssa = SsaBuilder::new(timing::at_rest(model), Precision::F64);
        ssa.block("law".to_owned(), "A law, and its slopes.".to_owned());
        let variable = ssa.make(Op::Time);
        ssa.params(model);
        let value = ssa.law(law, variable);
        let mut tangents = Tangents::new(Seed::Given, model.motors.len());
        let first = tangents.of_all_up_to(&mut ssa, value);
        let second = tangents.of_all_up_to(&mut ssa, first);
        Self { ssa: ssa.ssa, motors: model.motors.len(), values: [value, first, second] }
    }

    /// Its value and both derivatives, with these params: not finite where it has none.
    pub(super) fn at(&self, variable: f64, params: &[f64]) -> [f64; 3] {
        let mut values: Vec<f64> = Vec::with_capacity(self.ssa.nodes.len());
        for node in &self.ssa.nodes {
            let value = match node.op {
                Op::Time => variable,
                Op::Input(input) => self.param(input, params),
                // Rates of params are zero: they rest.
                op => op.apply(|value: Value| values[value.index()]).unwrap_or(0.0),
            };
            values.push(value);
        }
        self.values.map(|value| values[value.index()])
    }

    fn param(&self, input: InputId, params: &[f64]) -> f64 {
        let number = input.index().checked_sub(self.motors);
        let param = number.and_then(|number| params.get(number));
        param.copied().unwrap_or(f64::NAN)
    }
}
