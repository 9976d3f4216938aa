//! Params, and what is computed from them, as values of a program.

use super::builder::Builder;
use super::node::{Op, Value};
use crate::model::{Arithmetic, Model, ParamId};
use crate::plan::Algebra;

impl Builder {
    /// Computes everything that depends on params; what nothing needs of it is left out later.
    pub(super) fn write_formulas(&mut self, model: &Model) {
        self.motors = model.motors.len();
        let mut formulas = Formulas(self);
        for (param, id) in model.params.all().iter().zip(model.params.ids()) {
            let value = formulas.param(id);
            formulas.0.name(value, &param.name);
        }
        self.formulas = model.params.evaluate(&mut Formulas(self));
    }
}

/// What writes formulas into a program.
struct Formulas<'b>(&'b mut Builder);

impl Arithmetic for Formulas<'_> {
    type Scalar = Value;

    fn constant(&mut self, value: f64) -> Value {
        self.0.constant(value)
    }

    fn param(&mut self, param: ParamId) -> Value {
        // Params are given after the motors.
        self.0.make(Op::Motor(self.0.motors + param.index()))
    }

    fn neg(&mut self, a: Value) -> Value {
        self.0.neg(a)
    }

    fn add(&mut self, a: Value, b: Value) -> Value {
        self.0.add(a, b)
    }

    fn sub(&mut self, a: Value, b: Value) -> Value {
        self.0.sub(a, b)
    }

    fn mul(&mut self, a: Value, b: Value) -> Value {
        self.0.mul(a, b)
    }

    fn div(&mut self, a: Value, b: Value) -> Value {
        self.0.div(a, b)
    }

    fn sqrt(&mut self, a: Value) -> Value {
        self.0.sqrt(a)
    }

    fn sin(&mut self, a: Value) -> Value {
        self.0.make(Op::Sin(a))
    }

    fn cos(&mut self, a: Value) -> Value {
        self.0.make(Op::Cos(a))
    }
}
