//! Conversion of floats to phases, in whole numbers: a float is a whole number times a power of two.

use super::{Phase, ratio};

impl Phase {
    /// The phase of an angle in turns, rounded to the nearest 2^-64 turn, halves away from zero. `None` if it is not finite or exceeds the
    /// turns of an `i64`.
    ///
    /// ```
    /// use mech_core::Phase;
    ///
    /// assert_eq!(Phase::from_turns(-0.25), Phase::of_turn(-1, 4));
    /// assert_eq!(Phase::from_turns(1e19), None);
    /// assert_eq!(Phase::from_turns(f64::NAN), None);
    /// ```
    #[must_use]
    pub fn from_turns(turns: f64) -> Option<Self> {
        Self::of_parts(Parts::of(turns)?, 1)
    }

    /// The phase of an angle in degrees, rounded to the nearest 2^-64 turn, halves away from zero. `None` if it is not finite or exceeds the
    /// turns of an `i64`.
    ///
    /// ```
    /// use mech_core::Phase;
    ///
    /// assert_eq!(Phase::from_degrees(1.0), Phase::of_turn(1, 360));
    /// assert_eq!(Phase::from_degrees(f64::INFINITY), None);
    /// ```
    #[must_use]
    pub fn from_degrees(degrees: f64) -> Option<Self> {
        Self::of_parts(Parts::of(degrees)?, 360)
    }

    /// The phase of an angle in radians, rounded to the nearest 2^-64 turn. `None` if it is not finite or exceeds the turns of an `i64`.
    ///
    /// The float counts exactly: `PI` is not half a turn, but the float next to it.
    ///
    /// ```
    /// use core::f64::consts::PI;
    /// use mech_core::Phase;
    ///
    /// let short_of_half = Phase::of_turn(1, 2).unwrap() - Phase::from_radians(PI).unwrap();
    /// assert_eq!(short_of_half, Phase::new(0, 360)); // 1.2e-16 radians
    /// ```
    #[must_use]
    pub fn from_radians(radians: f64) -> Option<Self> {
        // 1 / (2 pi) in units of 2^-192, rounded down. Less than 2^66 of those errors are less than 2^-126.
        const TURNS: [u64; 3] =
            [0x28BE_60DB_9391_054A, 0x7F09_D5F4_7D4D_3770, 0x36D8_A566_4F10_E410];
        let Parts { negative, whole, exponent } = Parts::of(radians)?;
        if exponent > 13 {
            return None; // 2^66 radians or more
        }
        // The product is (high + low / 2^64) * 2^exponent units.
        let [high, middle, low] = TURNS.map(|limb| u128::from(whole) * u128::from(limb));
        let middle = middle + (low >> 64);
        let high = high + (middle >> 64);
        let low = middle & u128::from(u64::MAX);
        let size = if exponent >= 0 {
            let fine = (high << exponent) + (low >> (64 - exponent));
            fine + (low >> (63 - exponent) & 1)
        } else {
            let twice = high.checked_shr(exponent.unsigned_abs() - 1).unwrap_or(0);
            (twice + 1) >> 1
        };
        Self::of_size(size, negative)
    }

    /// The phase of a float divided by a number below 2^9.
    fn of_parts(parts: Parts, per_turn: u128) -> Option<Self> {
        let whole = u128::from(parts.whole);
        let size = match parts.exponent {
            21.. => None, // 2^73 or more, which is more than 2^63 turns
            exponent @ 0..=20 => ratio(whole << exponent, per_turn),
            exponent @ -118..0 => ratio(whole, per_turn << -exponent),
            _ => Some(0), // less than 2^-65
        };
        Self::of_size(size?, parts.negative)
    }
}

/// A finite float: `whole * 2^exponent`, where `whole` has 53 bits, or fewer if the exponent is the least.
#[derive(Clone, Copy)]
struct Parts {
    negative: bool,
    whole: u64,
    exponent: i32,
}

impl Parts {
    fn of(value: f64) -> Option<Self> {
        const HIDDEN: u64 = 1 << 52;
        if !value.is_finite() {
            return None;
        }
        let bits = value.to_bits();
        let mantissa = bits & (HIDDEN - 1);
        let biased = (bits >> 52 & 0x7FF) as i32;
        Some(Self {
            negative: value.is_sign_negative(),
            whole: if biased == 0 { mantissa } else { mantissa | HIDDEN },
            exponent: biased.max(1) - 1075,
        })
    }
}
