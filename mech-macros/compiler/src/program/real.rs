//! The arithmetic of a program, the same in every reading of it.

use super::Position;
use super::node::{Op, Value};
use mech_core::Real;

impl Op {
    /// The result of the operation, if it is arithmetic on values; the others come from outside.
    // Programs are run many thousand times while they are compiled, and a compiler itself is often built without optimisation.
    #[expect(
        clippy::inline_always,
        reason = "without optimisation a call costs more than the operation"
    )]
    #[inline(always)]
    pub fn apply<T: Real>(self, get: impl Fn(Value) -> T) -> Option<T> {
        Some(match self {
            Self::Constant(number) => T::from_f64(number.get()),
            Self::Neg(a) => -get(a),
            Self::Abs(a) => get(a).abs(),
            Self::Sqrt(a) => get(a).sqrt(),
            Self::Add(a, b) => get(a) + get(b),
            Self::Sub(a, b) => get(a) - get(b),
            Self::Mul(a, b) => get(a) * get(b),
            Self::Div(a, b) => get(a) / get(b),
            Self::Sin(a) => get(a).sin_cos().0,
            Self::Cos(a) => get(a).sin_cos().1,
            Self::Max(a, b) => get(a).max(get(b)),
            Self::CopySign(a, b) => get(a).copysign(get(b)),
            Self::Choose(test, a, b) => {
                if get(test) >= T::ZERO {
                    get(a)
                } else {
                    get(b)
                }
            }
            Self::Atan2(a, b) => get(a).atan2(get(b)),
            Self::Round(a) => get(a).round(),
            Self::Exp(a) => get(a).exp(),
            Self::Stairs(stairs, place, share) => stairs.at(get(place), T::from_f64(share.get())),
            // All others come from outside.
            _ => return None,
        })
    }

    /// The result of the operation at the start, where nothing has turned, moves or acts, and no step is missing.
    pub(super) fn at_start(self, start: &Position<f64>, get: impl Fn(Value) -> f64) -> f64 {
        match self {
            Self::Input(input) => start.motors[input.index()],
            Self::Last(slot) => start.at(slot),
            // All else that comes from outside is zero.
            op => op.apply(get).unwrap_or(0.0),
        }
    }
}
