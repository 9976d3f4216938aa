//! Intervals of numbers that are never too narrow: every bound is rounded outwards.
//!
//! Own code: `inari` builds on x86-64 only with flags for newer processors, and has sine and cosine only with GMP and MPFR,
//! and `intervals` does not round outwards.

use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Beyond this many half turns an angle in floating point says too little about its sine.
const MANY_HALF_TURNS: f64 = 1e9;

/// All numbers between two bounds, both among them. Neither bound is ever not a number, and there is always a number between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    low: f64,
    high: f64,
}

impl Interval {
    /// All numbers.
    pub const ENTIRE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
    /// Nothing but zero.
    pub const ZERO: Self = Self { low: 0.0, high: 0.0 };
    /// Nothing but one.
    pub const ONE: Self = Self { low: 1.0, high: 1.0 };

    /// All numbers between these two, whichever is the greater; all numbers at all, if one of them is not a number.
    #[must_use]
    pub fn new(a: f64, b: f64) -> Self {
        let (low, high) = if a <= b { (a, b) } else { (b, a) };
        if low <= high && low < f64::INFINITY && high > f64::NEG_INFINITY {
            Self { low, high }
        } else {
            Self::ENTIRE
        }
    }

    /// Nothing but this number.
    #[must_use]
    pub fn point(number: f64) -> Self {
        Self::new(number, number)
    }

    /// Nothing but each of these numbers.
    pub(crate) fn points(numbers: &[f64]) -> Vec<Self> {
        numbers.iter().copied().map(Self::point).collect()
    }

    /// The least number in it.
    #[must_use]
    pub fn low(self) -> f64 {
        self.low
    }

    /// The greatest number in it.
    #[must_use]
    pub fn high(self) -> f64 {
        self.high
    }

    /// Returns its width, rounded upwards.
    #[must_use]
    pub fn width(self) -> f64 {
        add_up(self.high, -self.low)
    }

    /// Whether both of its bounds are finite.
    #[must_use]
    pub fn is_bounded(self) -> bool {
        self.low > f64::NEG_INFINITY && self.high < f64::INFINITY
    }

    /// Whether this number is in it.
    #[must_use]
    pub fn contains(self, number: f64) -> bool {
        self.low <= number && number <= self.high
    }

    /// A number in it, as near its middle as may be.
    #[must_use]
    pub fn middle(self) -> f64 {
        let middle = 0.5 * self.low + 0.5 * self.high;
        if middle.is_finite() {
            middle.clamp(self.low, self.high)
        } else {
            0.0_f64.clamp(self.low, self.high)
        }
    }

    /// Returns the intersection of both intervals; this one, if they have no number in common.
    #[must_use]
    pub fn meet(self, other: Self) -> Self {
        let (low, high) = (self.low.max(other.low), self.high.min(other.high));
        if low <= high { Self { low, high } } else { self }
    }

    /// All that is in one or the other or between them.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The product with itself.
    #[must_use]
    pub fn square(self) -> Self {
        let Self { low, high } = self.abs();
        Self { low: multiply_down(low, low).max(0.0), high: multiply_up(high, high) }
    }

    /// The absolute value.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.low >= 0.0 {
            self
        } else if self.high <= 0.0 {
            -self
        } else {
            let high = self.high.max(-self.low);
            Self { low: 0.0, high }
        }
    }

    /// The square roots of the numbers of this interval; negative numbers count as zero.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let root = |square: f64| square.max(0.0).sqrt();
        let (low, high) = (root(self.low), root(self.high));
        // The root of zero is exact.
        Self { low: low.next_down().max(0.0), high: if high > 0.0 { high.next_up() } else { 0.0 } }
    }

    /// The greater of two numbers.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self { low: self.low.max(other.low), high: self.high.max(other.high) }
    }

    /// The less of two numbers.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.min(other.high) }
    }

    /// The sizes of these numbers with the sign of the other interval; with both signs if that contains zero.
    #[must_use]
    pub fn copysign(self, sign: Self) -> Self {
        let size = self.abs();
        if sign.low > 0.0 {
            size
        } else if sign.high < 0.0 {
            -size
        } else {
            size.hull(-size)
        }
    }

    /// The sine of angles in radians.
    #[must_use]
    pub fn sin(self) -> Self {
        self.wave(libm::sin, 0.5)
    }

    /// The cosine of angles in radians.
    #[must_use]
    pub fn cos(self) -> Self {
        self.wave(libm::cos, 0.0)
    }

    /// A wave that is greatest at `top` half turns, and at every even number of half turns from there.
    fn wave(self, at: impl Fn(f64) -> f64, top: f64) -> Self {
        let whole = Self { low: -1.0, high: 1.0 };
        let (first, last) = (self.low / PI - top, self.high / PI - top);
        if !(first > -MANY_HALF_TURNS && last < MANY_HALF_TURNS && last - first < 2.0) {
            return whole;
        }
        // Extrema that only may lie inside are taken in: at such an end the wave differs from one by less than rounding.
        let near = |end: f64| 4.0 * f64::EPSILON * (1.0 + end.abs());
        let mut extremum = (first - near(first)).ceil();
        let (from, to) = (at(self.low), at(self.high));
        let mut bounds = Self { low: widen(from.min(to)).low, high: widen(from.max(to)).high };
        while extremum <= last + near(last) {
            if extremum % 2.0 == 0.0 {
                bounds.high = 1.0;
            } else {
                bounds.low = -1.0;
            }
            extremum += 1.0;
        }
        bounds.meet(whole)
    }

    /// The angles in (−π, π] of the vectors (`x`, `self`).
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let pi = PI.next_up();
        if x.low <= 0.0 && self.contains(0.0) {
            return Self { low: -pi, high: pi };
        }
        // Away from the cut the angle is greatest and least at corners.
        let corners =
            [(self.low, x.low), (self.low, x.high), (self.high, x.low), (self.high, x.high)];
        let angle = |(y, x): (f64, f64)| match (y.is_infinite(), x.is_infinite()) {
            // A corner at infinity stands for all angles of its quadrant.
            (true, true) if x > 0.0 => Self::new(0.0, FRAC_PI_2.copysign(y)),
            (true, true) => Self::new(FRAC_PI_2.copysign(y), PI.copysign(y)),
            _ => Self::point(libm::atan2(y, x)),
        };
        let [a, b, c, d] = corners.map(angle);
        let Self { low, high } = a.hull(b).hull(c.hull(d));
        Self { low: widen(low).low.max(-pi), high: widen(high).high.min(pi) }
    }

    /// e to these powers.
    #[must_use]
    pub fn exp(self) -> Self {
        Self {
            low: widen(libm::exp(self.low)).low.max(0.0),
            high: widen(libm::exp(self.high)).high,
        }
    }

    /// The nearest whole numbers, halves away from zero.
    #[must_use]
    pub fn round(self) -> Self {
        Self { low: libm::round(self.low), high: libm::round(self.high) }
    }
}

/// A result of the library of mathematics, with what that may be wrong by: a little less than the last digit.
fn widen(number: f64) -> Interval {
    Interval { low: number.next_down().next_down(), high: number.next_up().next_up() }
}

/// By how much a rounded sum is too small. Not a number where something is infinite.
fn lost(a: f64, b: f64, sum: f64) -> f64 {
    let remainder = sum - a;
    (a - (sum - remainder)) + (b - remainder)
}

/// The sum, rounded downwards if it is not exact.
fn add_down(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if lost(a, b, sum) >= 0.0 { sum } else { sum.next_down() }
}

/// The sum, rounded upwards if it is not exact.
fn add_up(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if lost(a, b, sum) <= 0.0 { sum } else { sum.next_up() }
}

/// The product rounded downwards. Zero times infinity is zero: a factor of zero makes the whole product vanish.
fn multiply_down(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { (a * b).next_down() }
}

fn multiply_up(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { (a * b).next_up() }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { low: add_down(self.low, other.low), high: add_up(self.high, other.high) }
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;

    /// The product of independent numbers: for the same number twice there is [`square`](Self::square).
    fn mul(self, other: Self) -> Self {
        if self.low >= 0.0 {
            times_positive(other, self)
        } else if self.high <= 0.0 {
            -times_positive(other, -self)
        } else if other.low >= 0.0 {
            times_positive(self, other)
        } else if other.high <= 0.0 {
            -times_positive(self, -other)
        } else {
            let (a, b) = (self, other);
            Self {
                low: multiply_down(a.low, b.high).min(multiply_down(a.high, b.low)),
                high: multiply_up(a.low, b.low).max(multiply_up(a.high, b.high)),
            }
        }
    }
}

/// The product of any interval with one that has no negative numbers.
fn times_positive(any: Interval, positive: Interval) -> Interval {
    let (near, far) = (positive.low, positive.high);
    Interval {
        low: multiply_down(any.low, if any.low < 0.0 { far } else { near }),
        high: multiply_up(any.high, if any.high < 0.0 { near } else { far }),
    }
}

impl Div for Interval {
    type Output = Self;

    /// All quotients; all numbers, if the divisor may be zero.
    fn div(self, other: Self) -> Self {
        let (any, positive) = if other.low > 0.0 {
            (self, other)
        } else if other.high < 0.0 {
            (-self, -other)
        } else {
            return Self::ENTIRE;
        };
        let (near, far) = (positive.low, positive.high);
        let low = any.low / if any.low < 0.0 { near } else { far };
        let high = any.high / if any.high < 0.0 { far } else { near };
        Self {
            low: if any.low == 0.0 { 0.0 } else { low.next_down() },
            high: if any.high == 0.0 { 0.0 } else { high.next_up() },
        }
    }
}
