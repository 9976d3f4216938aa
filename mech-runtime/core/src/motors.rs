//! Motors on a move: how far they go, in which sense, and what that means for the loops that follow them.

use crate::Real;

/// How far a motor goes from one value, and whole turns besides, to another.
#[inline]
pub fn way<T: Real>((from, turns): (T, i32), (to, more): (T, i32)) -> T {
    let way = to - from;
    match more.wrapping_sub(turns) {
        0 => way,
        turns => way + T::TURN * T::from_i32(turns),
    }
}

/// What a part of so many whole turns comes to, less whole turns: an angle in radians. Exact up to the last rounding.
#[inline]
#[must_use]
pub fn turned<T: Real>(turns: i32, numerator: i64, denominator: i64) -> T {
    if turns == 0 {
        return T::ZERO;
    }
    let (turns, numerator, denominator) = (
        i128::from(turns),
        i128::from(numerator),
        i128::from(denominator),
    );
    let rest = (turns * numerator)
        .checked_rem_euclid(denominator)
        .unwrap_or(0);
    #[expect(clippy::cast_precision_loss, reason = "a fraction of a turn, rounded")]
    let part = rest as f64 / denominator as f64;
    T::TURN * T::from_f64(part)
}

/// By how much a quantity changes at most whose rates with the motors are no greater than these.
#[inline]
pub fn change<T: Real>(rates: impl IntoIterator<Item = T>, ways: &[T]) -> T {
    let parts = rates.into_iter().zip(ways);
    parts.fold(T::ZERO, |change, (rate, way)| change + rate * way.abs())
}

/// Positive if the motors that a quantity follows go on in these senses, negative if they go back.
pub fn along<T: Real>(rates: impl IntoIterator<Item = T>, ways: &[T], senses: &[T]) -> T {
    let parts = rates.into_iter().zip(ways).zip(senses);
    parts.fold(T::ZERO, |along, ((rate, way), sense)| {
        along + rate * *way * *sense
    })
}

/// Notes the sense of every motor that goes: one, or minus one.
#[inline]
pub fn note_senses<T: Real>(senses: &mut [T], ways: &[T]) {
    for (sense, way) in senses.iter_mut().zip(ways) {
        if *way != T::ZERO {
            *sense = T::ONE.copysign(*way);
        }
    }
}

/// Whether no motor goes farther than its stride.
#[inline]
pub fn in_one_piece<T: Real>(strides: impl IntoIterator<Item = T>, ways: &[T]) -> bool {
    let mut parts = strides.into_iter().zip(ways);
    parts.all(|(stride, way)| way.abs() <= stride)
}

/// In how many pieces the motors have to go if in each they go no farther than these strides.
#[inline]
pub fn pieces<T: Real>(strides: impl IntoIterator<Item = T>, ways: &[T]) -> T {
    let parts = strides.into_iter().zip(ways);
    parts.fold(T::ONE, |most, (stride, way)| most.max(way.abs() / stride))
}
