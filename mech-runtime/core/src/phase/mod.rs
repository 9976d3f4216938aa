//! Exact angles of motors.

mod direction;
mod from_float;

pub(crate) use direction::{HEAD_F32, TAIL_F32};

use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// The exact angle of a motor: whole turns, and a fraction of a turn in units of 2^-64 turn (3.4e-19 radians).
///
/// The angle is `turns + fraction / 2^64` turns. The fraction of a negative angle counts upwards too: minus a quarter turn is -1 turn and
/// three quarters.
///
/// Sums, differences and multiples are exact. Only the step is rounded, once, by at most half a unit, so a motor that steps for years is
/// where it should be. The turns wrap around beyond those of an `i64`. Nothing panics, even in debug builds.
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
    /// The angle zero.
    pub const ZERO: Self = Self::new(0, 0);

    /// An angle of whole turns, and a fraction in units of 2^-64 turn.
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

    /// A rational number of turns, rounded to the nearest 2^-64 turn. `None` if the denominator is zero.
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

    /// The fraction of a turn above the whole turns, in units of 2^-64 turn.
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

    /// An angle of `size` units, or minus as many. `None` if the turns are beyond `i64`.
    const fn of_size(size: u128, negative: bool) -> Option<Self> {
        if size > i128::MIN.unsigned_abs() || size == i128::MIN.unsigned_abs() && !negative {
            return None;
        }
        let units = size.cast_signed();
        Some(Self::of_units(if negative { units.wrapping_neg() } else { units }))
    }
}

/// The ratio in units of 2^-64, rounded to nearest, halves up. `None` if it exceeds 2^63.
///
/// The denominator is not zero. It or the numerator is less than about 2^63, so that the shifted remainder fits.
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
