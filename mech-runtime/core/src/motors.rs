//! The motors of a move: their displacements and signs of motion, and what these mean for the loops that follow them.

use crate::Real;

/// The displacement of a motor. Both values have their whole turns apart.
#[inline]
pub fn displacement<T: Real>((from, turns): (T, i32), (to, more): (T, i32)) -> T {
    let difference = to - from;
    match more.wrapping_sub(turns) {
        0 => difference,
        turns => difference + T::TURN * T::from_i32(turns),
    }
}

/// The value of a turning motor, between −π and π, and its whole turns: those in the value are added to those given. Beyond 2³¹ turns
/// both stay as they are.
#[inline]
#[must_use]
pub fn reduced<T: Real>(value: T, turns: i32) -> (T, i32) {
    if value.abs() <= T::HALF * T::TURN {
        return (value, turns);
    }
    let split = value.whole_turns();
    let sum = split.and_then(|(whole, remainder)| Some((remainder, turns.checked_add(whole)?)));
    sum.unwrap_or((value, turns))
}

/// A fraction of so many whole turns, as an angle in radians without whole turns. The fraction is computed exactly, and only the angle is
/// rounded. A denominator that is not positive gives zero.
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
    let (remainder, denominator) = if let (Ok(numerator), Ok(denominator)) = small {
        let remainder = small_remainder(turns, numerator, denominator);
        (T::from_i32(remainder.into()), T::from_i32(denominator.into()))
    } else {
        let remainder = remainder(turns, numerator, denominator);
        (T::from_i64(remainder), T::from_i64(denominator))
    };
    T::TURN * (remainder / denominator)
}

/// `turns * numerator` less whole multiples of the denominator, which is greater than the numerator.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "what is left is less than the denominator")]
fn small_remainder(turns: i32, numerator: u16, denominator: u16) -> u16 {
    let turns = turns.checked_rem_euclid(denominator.into()).unwrap_or(0);
    let product = turns.unsigned_abs().wrapping_mul(numerator.into());
    product.checked_rem(denominator.into()).unwrap_or(0) as u16
}

/// The remainder of `turns · numerator` by any denominator, found bit by bit: the product itself may be too large for the type.
fn remainder(turns: i32, numerator: i64, denominator: i64) -> i64 {
    let less = |sum: i64| if sum < 0 { sum + denominator } else { sum };
    let back = denominator - numerator;
    let mut remainder = 0;
    for bit in (0..i32::BITS).rev() {
        // Twice it, and then the numerator more, each less the denominator at once: so nothing overflows.
        remainder = less(remainder - (denominator - remainder));
        if turns.unsigned_abs() >> bit & 1 == 1 {
            remainder = less(remainder - back);
        }
    }
    if turns < 0 && remainder > 0 { denominator - remainder } else { remainder }
}

/// By how much a quantity changes at most whose rates with the motors are no greater than these.
#[inline]
pub fn change<T: Real>(rates: impl IntoIterator<Item = T>, displacements: &[T]) -> T {
    let parts = rates.into_iter().zip(displacements);
    parts.fold(T::ZERO, |change, (rate, displacement)| change + rate * displacement.abs())
}

/// Positive if the motors that a quantity follows go on with these signs of motion, negative if they go back.
pub fn along<T: Real>(
    rates: impl IntoIterator<Item = T>,
    displacements: &[T],
    motion_signs: &[T],
) -> T {
    let parts = rates.into_iter().zip(displacements).zip(motion_signs);
    parts.fold(T::ZERO, |along, ((rate, displacement), sign)| along + rate * *displacement * *sign)
}

/// Records the sign of motion of every motor that goes: one, or minus one.
#[inline]
pub fn note_motion_signs<T: Real>(motion_signs: &mut [T], displacements: &[T]) {
    for (sign, displacement) in motion_signs.iter_mut().zip(displacements) {
        if *displacement != T::ZERO {
            *sign = T::ONE.copysign(*displacement);
        }
    }
}

/// Whether no motor goes farther than its longest step.
#[inline]
pub fn in_one_piece<T: Real>(max_steps: impl IntoIterator<Item = T>, displacements: &[T]) -> bool {
    let mut parts = max_steps.into_iter().zip(displacements);
    parts.all(|(max_step, displacement)| displacement.abs() <= max_step)
}

/// In how many pieces the motors have to go if in each they go no farther than their longest steps.
#[inline]
pub fn pieces<T: Real>(max_steps: impl IntoIterator<Item = T>, displacements: &[T]) -> T {
    let parts = max_steps.into_iter().zip(displacements);
    parts.fold(T::ONE, |most, (max_step, displacement)| most.max(displacement.abs() / max_step))
}

/// Returns the number that lies as far beyond `at` as `before` lies before it.
#[inline]
pub fn mirrored<T: Real>(before: T, at: T) -> T {
    at + (at - before)
}

/// The same for the state of a position. Numbers of watched loops, by their indices, stay as they are, and so do the signs of motion
/// at the end.
#[inline]
pub fn mirror_state<T: Real>(
    state: &mut [T],
    before: &[T],
    motion_signs: Option<usize>,
    watched: &(impl Iterator<Item = [usize; 2]> + Clone),
) {
    let is_watched =
        |index: usize| watched.clone().any(|[sine, square]| index == sine || index == square);
    let angles = motion_signs.unwrap_or(state.len());
    let all = state.iter_mut().zip(before).enumerate().take(angles);
    for (_, (at, before)) in all.filter(|(index, _)| !is_watched(*index)) {
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
