//! Numbers of about thirty digits, in which the reference is computed: sums of two floats that do not overlap.
//!
//! Sums, products and quotients are those of Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building
//! blocks of double-word arithmetic" (2017). There are crates for these, but their sines are good for 17 digits only.

use mech_runtime::{Phase, Real};
use std::cmp::Ordering;
use std::f64::consts::FRAC_PI_2;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The sum of two floats, the lower at most half an ulp of the higher.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DoubleDouble {
    high: f64,
    low: f64,
}

/// A right angle.
const QUARTER: DoubleDouble = DoubleDouble::new(FRAC_PI_2, 6.123_233_995_736_766e-17);
/// The terms of a series: at an eighth of a turn the last is below 1e-32.
const TERMS: i32 = 28;

impl DoubleDouble {
    const fn new(high: f64, low: f64) -> Self {
        Self { high, low }
    }

    /// The exact sum of two floats.
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self::new(high, (a - (high - part)) + (b - part))
    }

    /// The exact sum of two floats, of which the first is the greater.
    fn quick_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        Self::new(high, b - (high - a))
    }

    /// The exact product of two floats.
    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self::new(high, a.mul_add(b, -high))
    }

    /// Sine and cosine by their series, between the diagonals.
    fn series(self) -> (Self, Self) {
        let square = self * self;
        let (mut sin, mut cos) = (Self::ZERO, Self::ZERO);
        let (mut odd, mut even) = (self, Self::ONE);
        for term in (0..TERMS).step_by(2) {
            (sin, cos) = (sin + odd, cos + even);
            let next = |last: Self, n: i32| -last * square / Self::from_i32(n * (n + 1));
            (odd, even) = (next(odd, term + 2), next(even, term + 1));
        }
        (sin, cos)
    }
}

impl From<f64> for DoubleDouble {
    fn from(value: f64) -> Self {
        Self::new(value, 0.0)
    }
}

impl PartialOrd for DoubleDouble {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let highs = self.high.partial_cmp(&other.high)?;
        Some(highs.then(self.low.partial_cmp(&other.low)?))
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (highs, lows) = (
            Self::sum(self.high, other.high),
            Self::sum(self.low, other.low),
        );
        let first = Self::quick_sum(highs.high, highs.low + lows.high);
        Self::quick_sum(first.high, first.low + lows.low)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let main = Self::product(self.high, other.high);
        let cross = self.high.mul_add(other.low, self.low * other.high);
        Self::quick_sum(main.high, main.low + cross)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let remainder = self - other * first.into();
        let second = remainder.high / other.high;
        let remainder = remainder - other * second.into();
        let third = remainder.high / other.high;
        Self::quick_sum(first, second) + third.into()
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.high, -self.low)
    }
}

impl Real for DoubleDouble {
    // The last four bits are left to the roundings of a few operations.
    const EPSILON: f64 = 16.0 * f64::EPSILON * f64::EPSILON;
    const ZERO: Self = Self::new(0.0, 0.0);
    const ONE: Self = Self::new(1.0, 0.0);
    const HALF: Self = Self::new(0.5, 0.0);
    const TURN: Self = Self::new(4.0 * QUARTER.high, 4.0 * QUARTER.low);

    fn from_f64(value: f64) -> Self {
        value.into()
    }

    fn from_i32(value: i32) -> Self {
        f64::from(value).into()
    }

    #[allow(clippy::cast_precision_loss, reason = "the halves are exact")]
    fn from_i64(value: i64) -> Self {
        let low = value & 0xFFFF_FFFF;
        Self::sum((value - low) as f64, low as f64)
    }

    fn of_phase(phase: Phase) -> (i64, Self) {
        let part = |bits: u64| f64::from(u32::try_from(bits).unwrap_or_default());
        let fraction = phase.fraction();
        let (high, low) = (part(fraction >> 32), part(fraction & 0xFFFF_FFFF));
        let half = 2.0_f64.powi(-32);
        let fraction = Self::sum(high * half, low * half * half);
        let (turns, remainder) = if fraction >= Self::HALF {
            (phase.turns().saturating_add(1), fraction - Self::ONE)
        } else {
            (phase.turns(), fraction)
        };
        (turns, remainder * Self::TURN)
    }

    fn whole_turns(self) -> Option<(i32, Self)> {
        let turns = (self.high / Self::TURN.high).round();
        #[expect(
            clippy::cast_possible_truncation,
            reason = "a whole number within range"
        )]
        let whole = (turns.abs() <= f64::from(i32::MAX)).then_some(turns as i32)?;
        Some((whole, self - Self::from_f64(turns) * Self::TURN))
    }

    fn to_f64(self) -> f64 {
        self.high
    }

    #[allow(clippy::cast_possible_truncation, reason = "that is what is asked for")]
    fn to_i32(self) -> i32 {
        self.high as i32
    }

    fn abs(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }

    fn sqrt(self) -> Self {
        if self == Self::ZERO {
            return self;
        }
        let root = self.high.sqrt();
        let remainder = self - Self::product(root, root);
        Self::quick_sum(root, remainder.high / (2.0 * root))
    }

    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    fn copysign(self, sign: Self) -> Self {
        if self.high.is_sign_negative() == sign.high.is_sign_negative() {
            self
        } else {
            -self
        }
    }

    fn sin_cos(self) -> (Self, Self) {
        let quarters = (self.high / QUARTER.high).round();
        let (sin, cos) = (self - QUARTER * quarters.into()).series();
        match quarters.rem_euclid(4.0) {
            0.0 => (sin, cos),
            1.0 => (cos, -sin),
            2.0 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    fn atan2(self, x: Self) -> Self {
        // What is missing is so small that its tangent is as good.
        let near = Self::from(self.high.atan2(x.high));
        let (sin, cos) = near.sin_cos();
        let along = x * cos + self * sin;
        if along == Self::ZERO {
            return near;
        }
        near + (self * cos - x * sin) / along
    }

    fn exp(self) -> Self {
        if self.high.abs() >= 750.0 || !self.is_finite() {
            return self.high.exp().into();
        }
        // Of a small part of the power by Taylor's series, and that squared as often as the power was halved.
        let mut halvings = 0;
        let mut part = self;
        while part.high.abs() > 1.0 {
            part = part * Self::HALF;
            halvings += 1;
        }
        let (mut sum, mut term) = (Self::ONE, Self::ONE);
        for order in 1..=30 {
            term = term * part / Self::from_i32(order);
            sum = sum + term;
        }
        (0..halvings).fold(sum, |power, _| power * power)
    }

    fn round(self) -> Self {
        let whole = self.high.round();
        if whole == self.high {
            return Self::quick_sum(whole, self.low.round());
        }
        let is_half = (self.high - self.high.trunc()).abs() == 0.5;
        if is_half && self.low * self.high < 0.0 {
            return self.high.trunc().into();
        }
        whole.into()
    }

    fn is_finite(self) -> bool {
        self.high.is_finite() && self.low.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::SQRT_2;

    /// Compares with digits that were computed with sixty.
    fn near(found: DoubleDouble, high: f64, low: f64) {
        let off = (found - DoubleDouble::new(high, low)).to_f64().abs();
        assert!(off < 1e-31, "{found:?} is {off:e} off");
    }

    #[test]
    fn arithmetic() {
        let number = DoubleDouble::from;
        near(number(2.0).sqrt(), SQRT_2, -9.667_293_313_452_913e-17);
        near(
            number(1.0) / number(7.0),
            0.142_857_142_857_142_85,
            7.930_164_461_608_26e-18,
        );
        let third = number(1.0) / number(3.0);
        near(third, 0.333_333_333_333_333_3, 1.850_371_707_708_594e-17);
        near(
            third * number(3.0) - number(1.0) + third * third,
            0.111_111_111_111_111_1,
            6.167_905_692_361_981e-18,
        );
        assert!(number(-1.0).sqrt().high.is_nan());
    }

    #[test]
    fn angles() {
        let (sin, cos) = DoubleDouble::ONE.sin_cos();
        near(sin, 0.841_470_984_807_896_5, 1.776_845_092_935_536e-18);
        near(cos, 0.540_302_305_868_139_8, -4.760_954_612_604_417e-17);
        let (sin, cos) = DoubleDouble::from(12.5).sin_cos();
        near(sin, -0.066_321_897_351_200_68, -4.628_667_126_141_473e-18);
        near(cos, 0.997_798_279_178_580_7, 3.360_244_743_411_041_4e-18);
        for eighth in -30..=30 {
            let angle = DoubleDouble::from_i32(eighth) / DoubleDouble::from_i32(10);
            let (sin, cos) = angle.sin_cos();
            near(sin.atan2(cos), angle.high, angle.low);
        }
    }

    #[test]
    fn powers() {
        let (e, small) = (std::f64::consts::E, 1.445_646_891_729_250_2e-16);
        near(DoubleDouble::ONE.exp(), e, small);
        near(
            (-DoubleDouble::ONE).exp() * DoubleDouble::new(e, small),
            1.0,
            0.0,
        );
        near(DoubleDouble::ZERO.exp(), 1.0, 0.0);
        assert_eq!(DoubleDouble::from(-1e9).exp(), DoubleDouble::ZERO);
    }

    #[test]
    fn rounding() {
        let tiny = 1e-20;
        for (high, low, whole) in [
            (2.5, 0.0, 3.0),
            (2.5, -tiny, 2.0),
            (-2.5, tiny, -2.0),
            (-2.5, -tiny, -3.0),
            (3.0, -tiny, 3.0),
            (0.25, tiny, 0.0),
        ] {
            assert_eq!(DoubleDouble::new(high, low).round(), whole.into());
        }
    }

    #[test]
    fn phases() {
        let phase = Phase::new(-3, 3 << 62);
        let (turns, remainder) = DoubleDouble::of_phase(phase);
        assert_eq!((turns, remainder), (-2, -QUARTER));
    }
}
