//! The operations of a program, on intervals.

use super::{Interval, stairs};
use crate::program::{Op, Part, Slot, Value};

/// The operation on intervals, if it is arithmetic; the others come from outside.
pub(super) fn natural(op: Op, get: impl Fn(Value) -> Interval) -> Option<Interval> {
    Some(match op {
        Op::Constant(number) => Interval::point(number.get()),
        // A range is one of values with all their turns in them: there are none besides.
        Op::Turns(_) | Op::PartOfTurns(..) => Interval::ZERO,
        Op::Last(Slot::Pose(_, Part::Cos | Part::Sin)) => direction(),
        Op::Input(_)
        | Op::Last(_)
        | Op::Unknown(..)
        | Op::Solved(..)
        | Op::Dense(..)
        | Op::Time
        | Op::Rate(_)
        | Op::Acceleration(_)
        | Op::Load(_)
        | Op::Linear(..) => return None,
        Op::Neg(a) => -get(a),
        Op::Abs(a) => get(a).abs(),
        Op::Sqrt(a) => get(a).sqrt(),
        Op::Add(a, b) => get(a) + get(b),
        Op::Sub(a, b) => get(a) - get(b),
        Op::Mul(a, b) if a == b => get(a).square(),
        Op::Mul(a, b) => get(a) * get(b),
        Op::Div(a, b) => get(a) / get(b),
        Op::Sin(a) => get(a).sin(),
        Op::Cos(a) => get(a).cos(),
        Op::Max(a, b) => get(a).max(get(b)),
        Op::CopySign(a, b) => get(a).copysign(get(b)),
        Op::Choose(test, a, b) => {
            let (test, a, b) = (get(test), get(a), get(b));
            if test.low() >= 0.0 {
                a
            } else if test.high() < 0.0 {
                b
            } else {
                a.hull(b)
            }
        }
        Op::Atan2(a, b) => get(a).atan2(get(b)),
        Op::Round(a) => get(a).round(),
        Op::Exp(a) => get(a).exp(),
        Op::Stairs(stairs, place, share) => stairs::heights(stairs, get(place), share.get()),
    })
}

/// The sign of all of an interval's numbers but zero.
pub(super) fn sign(of: Interval) -> Option<f64> {
    if of.low() >= 0.0 {
        Some(1.0)
    } else if of.high() <= 0.0 {
        Some(-1.0)
    } else {
        None
    }
}

/// The sign of all of an interval's numbers, if zero is not among them.
pub(super) fn strict_sign(of: Interval) -> Option<f64> {
    if of.contains(0.0) { None } else { sign(of) }
}

/// The range of the numbers of a direction, wider than one in case rounding made it longer.
pub(super) fn direction() -> Interval {
    Interval::new(-2.0, 2.0)
}
