//! Taylor's arithmetic: laws to second order, apart from the compiler's derivatives.

use mech_compiler::model::{
    Arithmetic, BinaryFunction, FormulaArithmetic, Function, Law, Number, ParamId,
};
use mech_core::Staircase;

/// What a law is, to second order, in another arithmetic: Taylor's.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jet(pub(super) [f64; 3]);

impl Jet {
    fn product(self, other: Self) -> Self {
        let (Self([a, b, c]), Self([p, q, r])) = (self, other);
        Self([a * p, a * q + b * p, a * r + 2.0 * b * q + c * p])
    }

    /// A function of it, by its value and its first two derivatives there.
    fn through(self, [value, first, second]: [f64; 3]) -> Self {
        let Self([_, b, c]) = self;
        Self([value, first * b, second * b * b + first * c])
    }

    fn plus(self, other: Self, sign: f64) -> Self {
        Self(std::array::from_fn(|order| self.0[order] + sign * other.0[order]))
    }
}

/// What gives the jet of a law at a time.
struct At(f64);

impl Arithmetic for At {
    type Scalar = Jet;

    fn constant(&mut self, value: f64) -> Jet {
        Jet([value, 0.0, 0.0])
    }

    fn neg(&mut self, Jet(a): Jet) -> Jet {
        Jet(a.map(|part| -part))
    }

    fn add(&mut self, a: Jet, b: Jet) -> Jet {
        a.plus(b, 1.0)
    }

    fn sub(&mut self, a: Jet, b: Jet) -> Jet {
        a.plus(b, -1.0)
    }

    fn mul(&mut self, a: Jet, b: Jet) -> Jet {
        a.product(b)
    }

    fn div(&mut self, a: Jet, b: Jet) -> Jet {
        let below = b.0[0];
        let inverse = [1.0 / below, -below.powi(-2), 2.0 * below.powi(-3)];
        a.product(b.through(inverse))
    }
}

impl FormulaArithmetic for At {
    fn variable(&mut self, _: usize) -> Jet {
        Jet([self.0, 1.0, 0.0])
    }

    fn param(&mut self, _: ParamId) -> Jet {
        unreachable!("no law here has a param")
    }

    fn of(&mut self, function: Function, a: Jet) -> Jet {
        let x = a.0[0];
        a.through(match function {
            Function::Sqrt => [x.sqrt(), 0.5 / x.sqrt(), -0.25 / (x * x.sqrt())],
            Function::Sin => [x.sin(), x.cos(), -x.sin()],
            Function::Cos => [x.cos(), -x.sin(), -x.cos()],
            Function::Tan => {
                let first = 1.0 + x.tan() * x.tan();
                [x.tan(), first, 2.0 * x.tan() * first]
            }
            Function::Asin | Function::Acos => {
                let first = (1.0 - x * x).sqrt().recip();
                let second = x * first.powi(3);
                if function == Function::Asin {
                    [x.asin(), first, second]
                } else {
                    [x.acos(), -first, -second]
                }
            }
            Function::Atan => {
                let first = 1.0 / (1.0 + x * x);
                [x.atan(), first, -2.0 * x * first * first]
            }
            Function::Exp => [x.exp(); 3],
            Function::Abs => [x.abs(), x.signum(), 0.0],
            Function::Floor => [x.floor(), 0.0, 0.0],
            Function::Sign if x == 0.0 => [0.0; 3],
            Function::Sign => [x.signum(), 0.0, 0.0],
        })
    }

    fn of_both(&mut self, function: BinaryFunction, a: Jet, b: Jet) -> Jet {
        let (x, y) = (a.0[0], b.0[0]);
        match function {
            BinaryFunction::Min if x > y => b,
            BinaryFunction::Max if x <= y => b,
            BinaryFunction::Min | BinaryFunction::Max => a,
            BinaryFunction::Atan2 => {
                let angle = x.atan2(y);
                let square = a.product(a).plus(b.product(b), 1.0);
                let (s, [_, ds, _]) = (square.0[0], square.0);
                let rate = (a.0[1] * y - b.0[1] * x) / s;
                let change = a.0[2] * y - b.0[2] * x;
                Jet([angle, rate, change / s - rate * ds / s])
            }
            BinaryFunction::Hypot => {
                let square = a.product(a).plus(b.product(b), 1.0);
                let root = square.0[0].sqrt();
                square.through([root, 0.5 / root, -0.25 / (root * square.0[0])])
            }
            BinaryFunction::Mod => {
                let times = Jet([(x / y).floor(), 0.0, 0.0]);
                let Jet([_, first, second]) = a.plus(b.product(times), -1.0);
                Jet([x - y * (x / y).floor(), first, second])
            }
        }
    }

    fn stairs(&mut self, stairs: Staircase, a: Jet, share: Number) -> Jet {
        let share = share.get();
        let [height, first, second] =
            [0, 1, 2].map(|order| Staircase { order, ..stairs }.at(a.0[0], share));
        a.through([height, first / share, second / (share * share)])
    }
}

/// The jet of a law at a time.
pub(super) fn jet(law: &Law, time: f64) -> Jet {
    law.evaluate(&mut At(time))
}
