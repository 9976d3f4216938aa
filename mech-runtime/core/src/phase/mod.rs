//! A motor's angle that loses nothing.

mod direction;
mod from_float;

pub(crate) use direction::{HEAD_F32, TAIL_F32};

use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// A motor's angle: whole turns, and a fraction of a turn in units of 2^-64 turn.
///
/// The angle is `turns + fraction / 2^64` turns, so the fraction also of a negative angle counts upwards: minus a quarter
/// turn is -1 turn and three quarters. The unit is 3.4e-19 radians. Sums, differences and multiples are exact, so that what
/// is stepped through for years is where it should be: all that is ever rounded is the step, once, when it is made, by at
/// most half a unit. The turns wrap around beyond those of an `i64`. Nothing panics, in debug builds neither.
///
/// ```
/// use mech_core::Phase;
///
/// let degree = Phase::of_turn(1, 360).unwrap();
/// let mut phase = Phase::ZERO;
/// for _ in 0..360_000 {
///     phase += degree;
/// }
/// assert_eq!(phase, degree * 360_000);
///
/// let (turns, rest) = phase.split_f64();
/// assert_eq!(turns, 1000);
/// assert!(rest.abs() < 1e-13);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Phase {
    turns: i64,
    fraction: u64,
}

impl Phase {
    /// No angle at all.
    pub const ZERO: Self = Self::new(0, 0);

    /// So many turns and so many 2^-64ths of a turn.
    ///
    /// ```
    /// use mech_core::Phase;
    ///
    /// const MINUS_QUARTER: Phase = Phase::new(-1, 3 << 62);
    /// assert_eq!(Some(MINUS_QUARTER), Phase::of_turn(-1, 4));
    /// ```
    #[inline]
    #[must_use]
    pub const fn new(turns: i64, fraction: u64) -> Self {
        Self { turns, fraction }
    }

    /// A rational part of a turn, rounded to the nearest 2^-64 turn; `None` if the denominator is zero.
    ///
    /// ```
    /// use mech_core::Phase;
    ///
    /// const DEGREE: Phase = Phase::of_turn(1, 360).unwrap();
    /// assert_eq!(DEGREE.fraction(), 51_240_955_760_304_310);
    /// assert_eq!(Phase::of_turn(-3, 2), Some(Phase::new(-2, 1 << 63)));
    /// assert_eq!(Phase::of_turn(1, 0), None);
    /// ```
    #[inline]
    #[must_use]
    pub const fn of_turn(numerator: i64, denominator: u64) -> Option<Self> {
        if denominator == 0 {
            return None;
        }
        match ratio(numerator.unsigned_abs() as u128, denominator as u128) {
            Some(size) => Self::of_size(size, numerator < 0),
            None => None,
        }
    }

    /// The whole turns, rounded down.
    #[inline]
    #[must_use]
    pub const fn turns(self) -> i64 {
        self.turns
    }

    /// What is left of the whole turns, in units of 2^-64 turn.
    #[inline]
    #[must_use]
    pub const fn fraction(self) -> u64 {
        self.fraction
    }

    /// The whole angle in units of 2^-64 turn.
    #[inline]
    const fn units(self) -> i128 {
        (self.turns as i128) << 64 | self.fraction as i128
    }

    #[inline]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "these are the two halves"
    )]
    const fn of_units(units: i128) -> Self {
        Self::new((units >> 64) as i64, units as u64)
    }

    /// `size` units or as many backwards, `None` if the turns are beyond `i64`.
    const fn of_size(size: u128, negative: bool) -> Option<Self> {
        if size > i128::MIN.unsigned_abs() || size == i128::MIN.unsigned_abs() && !negative {
            return None;
        }
        let units = size.cast_signed();
        Some(Self::of_units(if negative {
            units.wrapping_neg()
        } else {
            units
        }))
    }
}

/// The ratio in units of 2^-64, rounded to nearest, halves up; `None` if it is more than 2^63.
///
/// The denominator is not zero, and it or the numerator is less than 2^63 or so, so that the rest fits in what it is
/// shifted in.
const fn ratio(numerator: u128, denominator: u128) -> Option<u128> {
    let (whole, remainder) = (numerator / denominator, numerator % denominator);
    if whole > 1 << 63 {
        return None;
    }
    Some((whole << 64) + ((remainder << 64) + denominator / 2) / denominator)
}

impl Add for Phase {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::of_units(self.units().wrapping_add(other.units()))
    }
}

impl Sub for Phase {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::of_units(self.units().wrapping_sub(other.units()))
    }
}

impl Neg for Phase {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::of_units(self.units().wrapping_neg())
    }
}

impl Mul<i64> for Phase {
    type Output = Self;

    #[inline]
    fn mul(self, count: i64) -> Self {
        Self::of_units(self.units().wrapping_mul(i128::from(count)))
    }
}

impl AddAssign for Phase {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Phase {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}
