//! Arithmetic modulo the prime 2⁶¹ − 1: a rank over it is exact, so no tolerance is involved.

use std::ops::{Add, Mul, Neg, Sub};

const P: u64 = (1 << 61) - 1;

/// A number modulo 2⁶¹ − 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Element(u64);

impl Element {
    pub(crate) const ZERO: Self = Self(0);
    pub(crate) const ONE: Self = Self(1);

    fn reduced(value: u64) -> Self {
        let folded = (value & P) + (value >> 61);
        Self(if folded >= P { folded - P } else { folded })
    }

    pub(crate) fn is_zero(self) -> bool {
        self.0 == 0
    }

    fn power(self, mut exponent: u64) -> Self {
        let mut base = self;
        let mut result = Self::ONE;
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = result * base;
            }
            base = base * base;
            exponent >>= 1;
        }
        result
    }

    /// The number that gives one when multiplied with this; zero for zero.
    pub(crate) fn inverse(self) -> Self {
        self.power(P - 2)
    }
}

impl From<i64> for Element {
    fn from(value: i64) -> Self {
        let size = Self::reduced(value.unsigned_abs());
        if value < 0 { -size } else { size }
    }
}

impl From<f64> for Element {
    /// Exact: a finite float is a whole number times a power of two. Anything else becomes zero.
    fn from(value: f64) -> Self {
        if !value.is_finite() {
            return Self::ZERO;
        }
        let bits = value.to_bits();
        let exponent = (bits >> 52) & 0x7ff;
        let fraction = bits & ((1 << 52) - 1);
        let (mantissa, exponent) =
            if exponent == 0 { (fraction, 1) } else { (fraction | 1 << 52, exponent) };
        // value = mantissa · 2^(exponent − 1075), and 2^61 = 1 here.
        let shift = (exponent + 61 * 20 - 1075) % 61;
        let size = Self::reduced(mantissa) * Self(1 << shift);
        if value < 0.0 { -size } else { size }
    }
}

impl Add for Element {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::reduced(self.0 + other.0)
    }
}

impl Neg for Element {
    type Output = Self;
    fn neg(self) -> Self {
        Self::reduced(P - self.0)
    }
}

impl Sub for Element {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Element {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = u128::from(self.0) * u128::from(other.0);
        #[expect(
            clippy::cast_possible_truncation,
            reason = "both factors have at most 61 bits, so each half has"
        )]
        let [low, high] = [product & u128::from(P), product >> 61].map(|half| half as u64);
        Self::reduced(low + high)
    }
}

/// Random elements from a fixed seed, so that builds are reproducible (splitmix64).
#[derive(Clone, Debug)]
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn roll(&mut self) -> Element {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        Element::reduced(z ^ (z >> 31))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_undoes_multiplication() {
        let mut dice = Dice::new(1);
        for _ in 0..100 {
            let a = dice.roll();
            assert_eq!(a * a.inverse(), Element::ONE);
            assert_eq!(a - a, Element::ZERO);
            assert_eq!(a + -a, Element::ZERO);
        }
    }

    #[test]
    fn floats_are_exact() {
        assert_eq!(Element::from(3.0), Element::from(3_i64));
        assert_eq!(Element::from(-0.375) * Element::from(8_i64), Element::from(-3_i64));
        assert_eq!(Element::from(1e300) * Element::from(1e300).inverse(), Element::ONE);
        assert_eq!(Element::from(2f64.powi(70)) * Element::from(2f64.powi(-70)), Element::ONE);
    }
}
