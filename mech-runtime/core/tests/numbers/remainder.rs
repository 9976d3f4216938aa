//! The remainder of a float of any size by right angles: additions and subtractions of long fractions, without 2/pi and without products.

use crate::reference::Pair;

/// Words of 64 bits after the point: pi is good for them all, and 2^1023 times its error is still nothing.
const WORDS: usize = 20;
/// The number of words after the last doubling.
const KEPT: usize = 4;

/// A number that is not negative: a whole part, then words after the point.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
struct Long<const N: usize>(u64, [u64; N]);

impl<const N: usize> Long<N> {
    /// 2^`exponent`, which is not more than 63.
    fn power(exponent: i32) -> Self {
        let mut number = Self(0, [0; N]);
        if exponent >= 0 {
            number.0 = 1 << exponent;
        } else {
            let bit = usize::try_from(-exponent - 1).unwrap();
            number.1[bit / 64] = 1 << (63 - bit % 64);
        }
        number
    }

    fn plus(mut self, other: &Self) -> Self {
        let mut carry = false;
        for (a, b) in self.1.iter_mut().zip(&other.1).rev() {
            (*a, carry) = carrying(u128::from(*a) + u128::from(*b) + u128::from(carry));
        }
        self.0 += other.0 + u64::from(carry);
        self
    }

    fn minus(mut self, other: &Self) -> Self {
        let mut borrow = false;
        for (a, b) in self.1.iter_mut().zip(&other.1).rev() {
            let (first, low) = a.overflowing_sub(*b);
            let (second, lower) = first.overflowing_sub(u64::from(borrow));
            (*a, borrow) = (second, low || lower);
        }
        self.0 -= other.0 + u64::from(borrow);
        self
    }

    fn over(mut self, by: u64) -> Self {
        let mut remainder = self.0 % by;
        self.0 /= by;
        for word in &mut self.1 {
            let long = u128::from(remainder) << 64 | u128::from(*word);
            *word = u64::try_from(long / u128::from(by)).unwrap();
            remainder = u64::try_from(long % u128::from(by)).unwrap();
        }
        self
    }

    fn is_zero(&self) -> bool {
        self.0 == 0 && self.1.iter().all(|word| *word == 0)
    }

    /// Less as many right angles as are in it, of which it has a few, and how many these are.
    fn reduce(mut self, right_angle: &Self) -> (Self, i64) {
        let mut count = 0;
        while self >= *right_angle {
            self = self.minus(right_angle);
            count += 1;
        }
        (self, count)
    }

    fn truncate(&self) -> Long<KEPT> {
        Long(self.0, std::array::from_fn(|word| self.1[word]))
    }

    /// The first 106 bits, for a number below one.
    fn pair(&self) -> Pair {
        assert_eq!(self.0, 0);
        let first = self.1.iter().position(|word| *word != 0).unwrap();
        let shift = self.1[first].leading_zeros();
        let word = |at: usize| u128::from(*self.1.get(first + at).unwrap_or(&0));
        let top = (word(0) << 64 | word(1)) << shift | word(2) >> (64 - shift);
        let scale = 2.0_f64.powi(-64 * i32::try_from(first).unwrap() - shift.cast_signed());
        let part = |shift: u32| i64::try_from(top >> shift & ((1 << 53) - 1)).unwrap();
        Pair::whole(part(75), scale * 2.0_f64.powi(-53))
            + Pair::whole(part(22), scale * 2.0_f64.powi(-106))
    }
}

fn carrying(sum: u128) -> (u64, bool) {
    let carry = sum > u128::from(u64::MAX);
    #[allow(clippy::cast_possible_truncation, reason = "that is the carry")]
    (sum as u64, carry)
}

/// The angle whose tangent is one part in `n`, by its series.
fn angle_of_one_in(n: u64) -> Long<WORDS> {
    let mut power = Long::power(0).over(n);
    let mut sums = [power, Long(0, [0; WORDS])];
    for k in 1.. {
        power = power.over(n * n);
        if power.is_zero() {
            break;
        }
        sums[k % 2] = sums[k % 2].plus(&power.over(2 * k as u64 + 1));
    }
    sums[0].minus(&sums[1])
}

/// Every power of two from the last place of 2^-10 on, less right angles.
pub(crate) struct Remainders {
    right_angle: Long<KEPT>,
    powers: Vec<(Long<KEPT>, i64)>,
}

const LEAST: i32 = -64;

impl Remainders {
    pub(crate) fn new() -> Self {
        // Machin: pi/4 = 4 atan(1/5) - atan(1/239).
        let fifth = angle_of_one_in(5);
        let twice = |x: Long<WORDS>| x.plus(&x);
        let right_angle = twice(twice(twice(fifth)).minus(&angle_of_one_in(239)));

        let (mut power, mut count) = (Long::power(LEAST), 0);
        let mut powers = Vec::new();
        for _ in LEAST..1024 {
            powers.push((power.truncate(), count));
            let (double, more) = twice(power).reduce(&right_angle);
            (power, count) = (double, (2 * count + more) % 4);
        }
        Self { right_angle: right_angle.truncate(), powers }
    }

    /// Returns the remainder of a finite float of at least 2^-10 by the nearest number of right angles, and that number modulo four.
    pub(crate) fn of(&self, x: f64) -> (Pair, i64) {
        let bits = x.to_bits();
        let whole = bits & ((1 << 52) - 1) | 1 << 52;
        let exponent = i32::try_from(bits >> 52 & 0x7FF).unwrap() - 1075;
        let first = usize::try_from(exponent - LEAST).unwrap();

        let (mut remainder, mut quadrant) = (Long(0, [0; KEPT]), 0);
        for (bit, (power, count)) in self.powers[first..].iter().take(53).enumerate() {
            if whole >> bit & 1 == 1 {
                let (sum, more) = remainder.plus(power).reduce(&self.right_angle);
                (remainder, quadrant) = (sum, quadrant + count + more);
            }
        }
        let beyond = self.right_angle.minus(&remainder);
        let (angle, quadrant) = if beyond < remainder {
            (-beyond.pair(), quadrant + 1)
        } else {
            (remainder.pair(), quadrant)
        };
        if x < 0.0 { (-angle, -quadrant) } else { (angle, quadrant) }
    }
}
