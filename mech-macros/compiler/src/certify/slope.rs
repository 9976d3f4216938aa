//! The partial derivatives of a cone's values by its variables, on a box: by intervals, operation by operation.

use super::cone::Cone;
use super::operation::{natural, sign, strict_sign};
use super::{Interval, stairs};
use crate::cancel;
use crate::program::{Op, Value};

/// The values of a cone on a box, and for each variable how fast they change with it.
#[derive(Clone, Debug)]
pub(crate) struct Slopes<'c> {
    cone: &'c Cone,
    values: Vec<Interval>,
    /// For each variable the slopes of all values.
    rates: Vec<Vec<Interval>>,
}

impl<'c> Slopes<'c> {
    pub(crate) fn new(cone: &'c Cone) -> Self {
        let count = cone.nodes.len();
        Self {
            values: vec![Interval::ENTIRE; count],
            rates: vec![vec![Interval::ZERO; count]; cone.variables.len()],
            cone,
        }
    }

    /// Finds everything on a box: for each variable an interval.
    pub(crate) fn run(&mut self, place: &[Interval]) {
        cancel::check();
        for (index, node) in self.cone.nodes.iter().enumerate() {
            self.values[index] = match node.op {
                Op::Input(variable) => place[variable.index()],
                // Of what comes from outside nothing is known.
                op => natural(op, |value| self.values[value.index()]).unwrap_or(Interval::ENTIRE),
            };
            for (variable, slopes) in self.rates.iter_mut().enumerate() {
                slopes[index] = match node.op {
                    Op::Input(own) if own.index() == variable => Interval::ONE,
                    op => slope(op, &self.values, self.values[index], slopes),
                };
            }
        }
    }

    /// A value.
    pub(crate) fn value(&self, value: Value) -> Interval {
        self.values[value.index()]
    }

    /// Returns the partial derivative of a value by a variable.
    pub(crate) fn slope(&self, value: Value, variable: usize) -> Interval {
        self.rates[variable][value.index()]
    }
}

/// The product. Zero times an unbounded interval is zero.
fn times(a: Interval, b: Interval) -> Interval {
    if a == Interval::ZERO || b == Interval::ZERO { Interval::ZERO } else { a * b }
}

/// Returns the derivative of an operation's result, from those of its operands.
fn slope(op: Op, values: &[Interval], result: Interval, slopes: &[Interval]) -> Interval {
    let value = |a: Value| values[a.index()];
    let rate = |a: Value| slopes[a.index()];
    if op.operands().all(|operand| rate(operand) == Interval::ZERO) {
        return Interval::ZERO;
    }
    let two = Interval::point(2.0);
    let either = |a: Interval, by: Option<f64>| match by {
        Some(by) => a * Interval::point(by),
        None => a.hull(-a),
    };
    match op {
        Op::Neg(a) => -rate(a),
        Op::Add(a, b) => rate(a) + rate(b),
        Op::Sub(a, b) => rate(a) - rate(b),
        Op::Mul(a, b) if a == b => times(two * value(a), rate(a)),
        Op::Mul(a, b) => times(value(a), rate(b)) + times(value(b), rate(a)),
        Op::Div(a, b) => (rate(a) - times(result, rate(b))) / value(b),
        Op::Sqrt(a) => rate(a) / (two * result),
        Op::Abs(a) => either(rate(a), sign(value(a))),
        Op::CopySign(a, b) => {
            let signs = sign(value(a)).zip(strict_sign(value(b)));
            either(rate(a), signs.map(|(a, b)| a * b))
        }
        Op::Sin(a) => times(value(a).cos(), rate(a)),
        Op::Cos(a) => times(-value(a).sin(), rate(a)),
        Op::Exp(a) => times(result, rate(a)),
        Op::Stairs(stairs, place, share) => {
            times(stairs::slopes(stairs, value(place), share.get()), rate(place))
        }
        // No vector of which an angle is taken is shorter than one.
        Op::Atan2(a, b) => {
            let (y, x) = (value(a), value(b));
            let square = (x.square() + y.square()).max(Interval::ONE);
            (times(x, rate(a)) - times(y, rate(b))) / square
        }
        Op::Max(a, b) => {
            if value(a).low() >= value(b).high() {
                rate(a)
            } else if value(b).low() >= value(a).high() {
                rate(b)
            } else {
                rate(a).hull(rate(b))
            }
        }
        Op::Choose(test, a, b) => {
            if value(test).low() >= 0.0 {
                rate(a)
            } else if value(test).high() < 0.0 {
                rate(b)
            } else {
                rate(a).hull(rate(b))
            }
        }
        // Between whole numbers nothing changes; what goes over to the next is followed elsewhere.
        Op::Round(_)
        | Op::Constant(_)
        | Op::Input(_)
        | Op::Turns(_)
        | Op::PartOfTurns(..)
        | Op::Last(_)
        | Op::Unknown(..)
        | Op::Solved(..)
        | Op::Dense(..)
        | Op::Time
        | Op::Rate(_)
        | Op::Acceleration(_)
        | Op::Load(_)
        | Op::Linear(..) => Interval::ZERO,
    }
}
