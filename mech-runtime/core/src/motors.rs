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

/// The value of a motor that turns, with the whole turns in it counted among those given besides: the rest is between −π and π.
/// Beyond 2³¹ turns it stays as it is.
#[inline]
#[must_use]
pub fn reduced<T: Real>(value: T, turns: i32) -> (T, i32) {
    if value.abs() <= T::HALF * T::TURN {
        return (value, turns);
    }
    let split = value.whole_turns();
    let sum = split.and_then(|(whole, rest)| Some((rest, turns.checked_add(whole)?)));
    sum.unwrap_or((value, turns))
}

/// What a part of so many whole turns comes to, less whole turns: an angle in radians. The part is exact, rounded is only what
/// it is in radians. The denominator is positive; if it is not, there is no such part, and the angle is zero.
#[inline]
#[must_use]
pub fn turned<T: Real>(turns: i32, numerator: i64, denominator: i64) -> T {
    let Some(numerator) = numerator.checked_rem_euclid(denominator) else {
        return T::ZERO;
    };
    if turns == 0 || denominator < 0 {
        return T::ZERO;
    }
    let small = (u16::try_from(numerator), u16::try_from(denominator));
    // Nearly every ratio is so small that one division of a processor of 32 bits does it.
    let (rest, denominator) = if let (Ok(numerator), Ok(denominator)) = small {
        let rest = small_rest(turns, numerator, denominator);
        (T::from_i32(rest.into()), T::from_i32(denominator.into()))
    } else {
        let rest = rest(turns, numerator, denominator);
        (T::from_i64(rest), T::from_i64(denominator))
    };
    T::TURN * (rest / denominator)
}

/// `turns * numerator` less whole multiples of the denominator, which is greater than the numerator.
#[inline]
#[expect(
    clippy::cast_possible_truncation,
    reason = "what is left is less than the denominator"
)]
fn small_rest(turns: i32, numerator: u16, denominator: u16) -> u16 {
    let turns = turns.checked_rem_euclid(denominator.into()).unwrap_or(0);
    let product = turns.unsigned_abs().wrapping_mul(numerator.into());
    product.checked_rem(denominator.into()).unwrap_or(0) as u16
}

/// The same for any denominator, bit by bit of the turns: the product may have more bits than there are.
fn rest(turns: i32, numerator: i64, denominator: i64) -> i64 {
    let less = |sum: i64| if sum < 0 { sum + denominator } else { sum };
    let back = denominator - numerator;
    let mut rest = 0;
    for bit in (0..i32::BITS).rev() {
        // Twice it, and then the numerator more, each less the denominator at once: so nothing overflows.
        rest = less(rest - (denominator - rest));
        if turns.unsigned_abs() >> bit & 1 == 1 {
            rest = less(rest - back);
        }
    }
    if turns < 0 && rest > 0 {
        denominator - rest
    } else {
        rest
    }
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

/// What lies as far beyond a number as another lies before it.
#[inline]
pub fn mirrored<T: Real>(before: T, at: T) -> T {
    at + (at - before)
}

/// The same for what is carried. Sines and the squares after them stay as they are, and so do the senses at the end.
#[inline]
pub fn mirror_carried<T: Real>(
    carried: &mut [T],
    before: &[T],
    senses: Option<usize>,
    sines: &(impl Iterator<Item = usize> + Clone),
) {
    let is_sine = |number: usize| {
        sines
            .clone()
            .any(|sine| number == sine || number == sine + 1)
    };
    let angles = senses.unwrap_or(carried.len());
    let all = carried.iter_mut().zip(before).enumerate().take(angles);
    for (_, (at, before)) in all.filter(|(number, _)| !is_sine(*number)) {
        *at = mirrored(*before, *at);
    }
}

/// The same for a pose: the cosine and sine of its angle, and its origin.
pub fn mirrored_pose<T: Real>([c, s, x, y]: [T; 4], [cos, sin, at_x, at_y]: [T; 4]) -> [T; 4] {
    // By what it has turned, it is turned once more.
    let (turned_cos, turned_sin) = (cos * c + sin * s, sin * c - cos * s);
    [
        cos * turned_cos - sin * turned_sin,
        sin * turned_cos + cos * turned_sin,
        mirrored(x, at_x),
        mirrored(y, at_y),
    ]
}
