//! Sine and cosine to some thirty digits, by Taylor's series in pairs of floats: nothing of it is shared with the crate.

use std::ops::{Add, Div, Mul, Neg};

/// The unevaluated sum of two floats, the second at most half an ulp of the first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair(pub(crate) f64, pub(crate) f64);

/// pi / 2 in parts of 53 bits, good for 2^-214.
const RIGHT_ANGLE: [u64; 4] =
    [0x3FF9_21FB_5444_2D18, 0x3C91_A626_3314_5C07, 0xB91F_1976_B7ED_8FBC, 0x35B4_CF98_E804_177D];

/// The sum of any two floats.
fn sum(a: f64, b: f64) -> Pair {
    let sum = a + b;
    let from_b = sum - a;
    Pair(sum, (a - (sum - from_b)) + (b - from_b))
}

/// The product of two floats that are not extreme.
fn product(a: f64, b: f64) -> Pair {
    let halves = |x: f64| {
        let wide = x * 134_217_729.0;
        let high = wide - (wide - x);
        (high, x - high)
    };
    let product = a * b;
    let ((a, c), (b, d)) = (halves(a), halves(b));
    Pair(product, ((a * b - product) + a * d + c * b) + c * d)
}

impl From<f64> for Pair {
    fn from(value: f64) -> Self {
        Self(value, 0.0)
    }
}

impl Neg for Pair {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Add for Pair {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (sum(self.0, other.0), sum(self.1, other.1));
        let first = sum(high.0, high.1 + low.0);
        sum(first.0, first.1 + low.1)
    }
}

impl Mul for Pair {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let main = product(self.0, other.0);
        sum(main.0, main.1 + (self.0 * other.1 + self.1 * other.0))
    }
}

impl Div<f64> for Pair {
    type Output = Self;

    fn div(self, by: f64) -> Self {
        let first = self.0 / by;
        let remainder = self + -product(first, by);
        sum(first, remainder.0 / by)
    }
}

impl Pair {
    /// A whole number times a power of two.
    pub(crate) fn whole(value: i64, scale: f64) -> Self {
        let high = value >> 32;
        let low = value - (high << 32);
        let part = |x: i64| f64::from(u32::try_from(x.unsigned_abs()).unwrap()) * scale;
        let sign = if high < 0 { -1.0 } else { 1.0 };
        sum(sign * part(high) * 4_294_967_296.0, part(low))
    }

    /// 2 pi.
    pub(crate) fn tau() -> Self {
        Self(4.0 * f64::from_bits(RIGHT_ANGLE[0]), 4.0 * f64::from_bits(RIGHT_ANGLE[1]))
    }
}

/// The distance of a float from the true value.
pub(crate) fn error(got: f64, truth: Pair) -> f64 {
    ((got - truth.0) - truth.1).abs()
}

/// The distance in units of the last place of the true value.
pub(crate) fn error_in_ulp(got: f64, truth: Pair) -> f64 {
    let size = truth.0.abs();
    // The truth may be below the power of two that its first part is.
    let ulp = if truth.0 * truth.1 < 0.0 { size - size.next_down() } else { size.next_up() - size };
    error(got, truth) / ulp
}

/// Sine and cosine by Taylor's series, for angles of at most one.
pub(crate) struct Taylor(Vec<Pair>);

impl Taylor {
    pub(crate) fn new() -> Self {
        let mut inverse = vec![Pair(1.0, 0.0)];
        for n in 1..=29_u32 {
            inverse.push(*inverse.last().unwrap() / f64::from(n));
        }
        Self(inverse)
    }

    fn series(&self, square: Pair, first: usize) -> Pair {
        let terms = self.0.iter().enumerate().skip(first).step_by(2);
        terms.rev().fold(Pair(0.0, 0.0), |value, (n, term)| {
            let term = if n / 2 % 2 == 0 { *term } else { -*term };
            value * square + term
        })
    }

    /// Of `angle` and `quadrant` right angles.
    pub(crate) fn sin_cos(&self, angle: Pair, quadrant: i64) -> (Pair, Pair) {
        // So small that the products below would be subnormal, and that the sine is the angle.
        if angle.0.abs() < 1e-60 {
            return rotate((angle, Pair(1.0, 0.0)), quadrant);
        }
        let square = angle * angle;
        let sine = angle * self.series(square, 1);
        rotate((sine, self.series(square, 0)), quadrant)
    }

    /// Of an angle in radians, of at most 2^31 right angles.
    #[allow(clippy::cast_possible_truncation, reason = "at most 2^31 right angles")]
    pub(crate) fn sin_cos_of_radians(&self, x: f64) -> (Pair, Pair) {
        let count = (x / f64::from_bits(RIGHT_ANGLE[0])).round();
        let mut remainder = Pair::from(x);
        for part in RIGHT_ANGLE {
            remainder = remainder + -product(count, f64::from_bits(part));
        }
        self.sin_cos(remainder, count as i64)
    }
}

fn rotate((sine, cosine): (Pair, Pair), quadrant: i64) -> (Pair, Pair) {
    match quadrant.rem_euclid(4) {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// A generator of numbers without a pattern: the same ones at every run.
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Between -1 and 1.
    #[allow(clippy::cast_precision_loss, reason = "some number is wanted")]
    pub(crate) fn float(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}
