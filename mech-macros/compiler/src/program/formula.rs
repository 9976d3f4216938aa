//! Formulas as values of a program: what is computed from params, and laws.

use super::builder::SsaBuilder;
use super::node::{Op, Value};
use crate::bug::bug;
use crate::model::{
    BinaryFunction, FormulaArithmetic, Function, InputId, Law, Model, Number, ParamId,
};
use crate::plan::{Algebra, Arithmetic};
use mech_core::Staircase;

impl SsaBuilder {
    /// Computes everything that depends on params; what nothing needs of it is left out later.
    pub(super) fn evaluate_formulas(&mut self, model: &Model) {
        self.params(model);
        self.formulas = model.params.evaluate(self);
    }

    /// The values of all params.
    pub(super) fn params(&mut self, model: &Model) -> Vec<Value> {
        self.motors = model.motors.len();
        let params = model.params.all().iter().zip(model.params.ids());
        params
            .map(|(param, id)| {
                let value = self.param(id);
                self.name(value, &param.name)
            })
            .collect()
    }

    /// A law of a value.
    pub(super) fn law(&mut self, law: &Law, variable: Value) -> Value {
        let others = std::mem::replace(&mut self.variables, vec![variable]);
        let value = law.evaluate(self);
        self.variables = others;
        value
    }
}

impl FormulaArithmetic for SsaBuilder {
    fn variable(&mut self, number: usize) -> Value {
        let Some(&variable) = self.variables.get(number) else {
            bug!("there is a variable outside of laws and requirements");
        };
        variable
    }

    /// Params are given after the motors.
    fn param(&mut self, param: ParamId) -> Value {
        self.make(Op::Input(InputId::of_param(param, self.motors)))
    }

    fn of(&mut self, function: Function, a: Value) -> Value {
        match function {
            Function::Sqrt => self.sqrt(a),
            Function::Sin => self.make(Op::Sin(a)),
            Function::Cos => self.make(Op::Cos(a)),
            Function::Tan => {
                let (sin, cos) = (self.make(Op::Sin(a)), self.make(Op::Cos(a)));
                self.div(sin, cos)
            }
            Function::Asin => {
                let other = self.other_leg(a);
                self.make(Op::Atan2(a, other))
            }
            Function::Acos => {
                let other = self.other_leg(a);
                self.make(Op::Atan2(other, a))
            }
            Function::Atan => {
                let one = self.constant(1.0);
                self.make(Op::Atan2(a, one))
            }
            Function::Exp => self.make(Op::Exp(a)),
            Function::Abs => self.abs(a),
            Function::Floor => self.floor(a),
            Function::Sign => {
                // Whatever it is divided by, what is not a number stays so.
                let size = self.abs(a);
                let (nothing, sign) = (self.constant(0.0), self.make(Op::Div(a, size)));
                let is_zero = self.neg(size);
                self.make(Op::Choose(is_zero, nothing, sign))
            }
        }
    }

    fn of_both(&mut self, function: BinaryFunction, a: Value, b: Value) -> Value {
        match function {
            BinaryFunction::Atan2 => {
                // Made at least as long as one: a vector without length has no direction, and is no number then.
                let (height, width) = (self.abs(a), self.abs(b));
                let greater = self.max(height, width);
                let [sin, cos] = [a, b].map(|side| self.make(Op::Div(side, greater)));
                self.make(Op::Atan2(sin, cos))
            }
            BinaryFunction::Hypot => {
                let square = self.dot([a, b], [a, b]);
                self.sqrt(square)
            }
            BinaryFunction::Min | BinaryFunction::Max => self.extreme(function, [a, b]),
            BinaryFunction::Mod => {
                // Divided, and not multiplied by the inverse: whole times the second leave nothing.
                let times = self.make(Op::Div(a, b));
                let times = self.floor(times);
                let taken = self.mul(b, times);
                self.sub(a, taken)
            }
        }
    }

    fn stairs(&mut self, stairs: Staircase, place: Value, share: Number) -> Value {
        self.make(Op::Stairs(stairs, place, share))
    }
}

impl SsaBuilder {
    /// The other leg of a right-angled triangle whose longest side is one.
    fn other_leg(&mut self, leg: Value) -> Value {
        let one = self.constant(1.0);
        let (less, more) = (self.sub(one, leg), self.add(one, leg));
        let square = self.mul(less, more);
        self.sqrt(square)
    }

    /// The greatest whole number that is not greater.
    fn floor(&mut self, a: Value) -> Value {
        let near = self.make(Op::Round(a));
        let one = self.constant(1.0);
        let (above, below) = (self.sub(a, near), self.sub(near, one));
        self.make(Op::Choose(above, near, below))
    }

    /// The lesser or greater of two values, of which none is lost that is NaN. With a constant it is exact; of two others it is one and how
    /// far the other goes beyond it.
    fn extreme(&mut self, extreme: BinaryFunction, [a, b]: [Value; 2]) -> Value {
        if extreme == BinaryFunction::Min {
            let opposites = [a, b].map(|value| self.neg(value));
            let greatest = self.extreme(BinaryFunction::Max, opposites);
            return self.neg(greatest);
        }
        // Where one is NaN, the second is the greater.
        match [a, b].map(|value| self.number(value).is_some()) {
            [true, _] => self.max(a, b),
            [false, true] => self.max(b, a),
            [false, false] => {
                let (zero, farther) = (self.constant(0.0), self.sub(b, a));
                let farther = self.max(zero, farther);
                self.add(a, farther)
            }
        }
    }
}
