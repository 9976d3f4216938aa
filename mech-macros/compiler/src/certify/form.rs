//! Affine forms: how values depend on the motors, to first order, and on what was left over before.
//!
//! A value is a middle, a part for each motor, and a part for each earlier operation, which stands for what that one left over
//! by not being linear and by rounding. So what is left over cancels where it must: plain intervals forget that two values hang
//! together, and lose a factor of a hundred with each loop of a chain.

use super::Interval;

/// The forms of all steps of a program, and the space for them.
#[derive(Clone, Debug)]
pub(super) struct Forms {
    motors: usize,
    /// For each step its middle, and the sum of its parts' sizes: infinite, if nothing is known.
    middles: Vec<f64>,
    radii: Vec<f64>,
    /// The parts, those of one step after those of another: first of the motors, then of all steps up to itself.
    parts: Vec<f64>,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Operand {
    /// All its values.
    pub(super) range: Interval,
    /// The step that makes it, if it depends on motors.
    pub(super) step: Option<usize>,
}

/// An operation as a linear one: factor · operand summed over both, and what is left over.
#[derive(Clone, Copy, Debug)]
pub(super) struct Linear {
    pub(super) factors: [f64; 2],
    pub(super) remainder: Interval,
}

impl Forms {
    /// Space for so many steps.
    pub(super) fn new(motors: usize, steps: usize) -> Self {
        Self {
            motors,
            middles: vec![0.0; steps],
            radii: vec![f64::INFINITY; steps],
            parts: vec![0.0; Self::begin(motors, steps)],
        }
    }

    /// Whether these are of so many steps.
    pub(super) fn are_of(&self, steps: usize) -> bool {
        self.middles.len() == steps
    }

    /// Where the parts of a step begin.
    fn begin(motors: usize, step: usize) -> usize {
        step * (motors + 1) + step * step.saturating_sub(1) / 2
    }

    fn row(&self, step: usize) -> &[f64] {
        &self.parts[Self::begin(self.motors, step)..Self::begin(self.motors, step + 1)]
    }

    /// The middle of an operand.
    pub(super) fn middle(&self, operand: Operand) -> f64 {
        operand.step.map_or_else(|| operand.range.middle(), |step| self.middles[step])
    }

    /// All values of a step.
    pub(super) fn range(&self, step: usize) -> Interval {
        let around = Interval::new(-self.radii[step], self.radii[step]);
        Interval::point(self.middles[step]) + around
    }

    /// The mean of a step over the values of a motor: what is linear in these is as often above its middle as below.
    pub(super) fn mean(&self, step: usize, motor: usize) -> Interval {
        let own = self.row(step)[motor].abs();
        let radius = rounded_up(self.radii[step], self.motors) - own;
        Interval::point(self.middles[step]) + Interval::new(-radius, radius)
    }

    /// All values of a − factor · b.
    pub(super) fn difference(&self, a: Operand, b: Operand, factor: f64) -> Interval {
        let natural = a.range - Interval::point(factor) * b.range;
        let (Some(first), Some(second)) = (a.step, b.step) else {
            return natural;
        };
        let sizes = self.radii[first] + factor.abs() * self.radii[second];
        if !sizes.is_finite() {
            return natural;
        }
        let (first_row, second_row) = (self.row(first), self.row(second));
        let common = first_row.len().min(second_row.len());
        let both = first_row.iter().zip(second_row);
        let sum: f64 = both.map(|(a, b)| (a - factor * b).abs()).sum();
        let alone = sum_of_sizes(&first_row[common..]);
        let other = sum_of_sizes(&second_row[common..]);
        let radius =
            rounded_up(sum + alone + factor.abs() * other, first.max(second) + self.motors)
                + 4.0 * f64::EPSILON * sizes;
        let middle = Interval::point(self.middles[first])
            - Interval::point(factor) * Interval::point(self.middles[second]);
        natural.meet(middle + Interval::new(-radius, radius))
    }

    /// A motor's value: its range.
    pub(super) fn motor(&mut self, step: usize, motor: usize, range: Interval) {
        let radius = self.clear(step, range);
        let begin = Self::begin(self.motors, step);
        self.parts[begin + motor] = radius;
    }

    /// A value of which nothing is known but its range.
    pub(super) fn fresh(&mut self, step: usize, range: Interval) {
        let radius = self.clear(step, range);
        let end = Self::begin(self.motors, step + 1);
        self.parts[end - 1] = radius;
    }

    fn clear(&mut self, step: usize, range: Interval) -> f64 {
        let row = Self::begin(self.motors, step)..Self::begin(self.motors, step + 1);
        self.parts[row].fill(0.0);
        let (middle, radius) = round(range);
        self.middles[step] = middle;
        self.radii[step] = radius;
        if radius.is_finite() { radius } else { 0.0 }
    }

    /// The result of an operation. Gives back whether anything can be said of it.
    pub(super) fn combine(&mut self, step: usize, operands: [Operand; 2], linear: Linear) -> bool {
        let Linear { factors, remainder } = linear;
        let (mut sum, mut sizes, mut loose) = (remainder, 0.0, 0.0);
        for (operand, factor) in operands.into_iter().zip(factors) {
            if factor == 0.0 {
                continue;
            }
            let (middle, radius) = match operand.step {
                Some(step) => (self.middles[step], self.radii[step]),
                None => round(operand.range),
            };
            sum = sum + Interval::point(factor) * Interval::point(middle);
            sizes += factor.abs() * radius;
            if operand.step.is_none() {
                loose += factor.abs() * radius;
            }
        }
        let (middle, own) = round(sum);
        let own = (own + loose + 4.0 * f64::EPSILON * sizes) * (1.0 + 4.0 * f64::EPSILON);
        if !(own + sizes).is_finite() {
            return false;
        }
        let begin = Self::begin(self.motors, step);
        let (before, after) = self.parts.split_at_mut(begin);
        let row = &mut after[..=self.motors + step];
        let mut is_begun = false;
        for (operand, factor) in operands.into_iter().zip(factors) {
            let (Some(step), true) = (operand.step, factor != 0.0) else {
                continue;
            };
            let from = Self::begin(self.motors, step);
            let parts = &before[from..=from + self.motors + step];
            if is_begun {
                add_scaled(row, factor, parts);
            } else {
                set_scaled(row, factor, parts);
            }
            is_begun = true;
        }
        if !is_begun {
            clear(row, 0);
        }
        row[self.motors + step] = own + f64::MIN_POSITIVE;
        let radius = sum_of_sizes(row);
        self.middles[step] = middle;
        self.radii[step] = rounded_up(radius, row.len());
        true
    }
}

/// Adds parts to a row, each times a factor. By numbers, as macros are mostly built without optimisation: there an iterator takes
/// many times as long, and this is what proofs spend their time on.
fn add_scaled(row: &mut [f64], factor: f64, parts: &[f64]) {
    let mut index = 0;
    while index < parts.len() {
        row[index] += factor * parts[index];
        index += 1;
    }
}

/// Sets a row to parts, each times a factor, and to nothing beyond them; by numbers, as in [`add_scaled`].
fn set_scaled(row: &mut [f64], factor: f64, parts: &[f64]) {
    let mut index = 0;
    while index < parts.len() {
        row[index] = factor * parts[index];
        index += 1;
    }
    clear(row, index);
}

/// Sets a row to nothing from here on; by numbers, as in [`add_scaled`].
fn clear(row: &mut [f64], from: usize) {
    let mut index = from;
    while index < row.len() {
        row[index] = 0.0;
        index += 1;
    }
}

/// The sum of the sizes of parts; by numbers, as in [`add_scaled`].
fn sum_of_sizes(parts: &[f64]) -> f64 {
    let (mut sum, mut index) = (0.0, 0);
    while index < parts.len() {
        sum += parts[index].abs();
        index += 1;
    }
    sum
}

/// An upper bound of a sum of so many terms that was rounded.
fn rounded_up(sum: f64, terms: usize) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "a few thousand terms")]
    let most = (terms + 8) as f64;
    sum * (1.0 + most * f64::EPSILON)
}

/// The middle of an interval and how far it reaches from there.
fn round(range: Interval) -> (f64, f64) {
    let middle = range.middle();
    let around = range - Interval::point(middle);
    (middle, around.abs().high())
}

/// A line that stays near the square root on a range, and how far the root is from it at most.
pub(super) fn root(range: Interval) -> Option<Linear> {
    if range.low() < 0.0 || range.high() <= 0.0 || !range.is_bounded() {
        return None;
    }
    let rate = 1.0 / (range.low().sqrt() + range.high().sqrt());
    let line = Interval::point(rate);
    let above = |number: f64| {
        let number = Interval::point(number);
        number.sqrt() - line * number
    };
    // The root lies above the line through its ends, and most where its own rate is the line's.
    let most = Interval::point(0.25) / line;
    let remainder = above(range.low()).hull(above(range.high())).hull(most);
    Some(Linear { factors: [rate, 0.0], remainder })
}

/// The greater of a number between two bounds and a constant between them.
pub(super) fn greater(range: Interval, constant: Interval) -> Option<Linear> {
    let rate = (range.high() - constant.middle()) / range.width();
    if !(range.is_bounded() && constant.is_bounded() && (0.0..=1.0).contains(&rate)) {
        return None;
    }
    let line = Interval::point(rate);
    let above = |number: f64| {
        let number = Interval::point(number);
        number.max(constant) - line * number
    };
    let least = constant - line * constant;
    let remainder = above(range.low()).hull(above(range.high())).hull(least);
    Some(Linear { factors: [rate, 0.0], remainder })
}

/// A line that stays near a sine or cosine on a range, and how far the curve is from it. Given are its value and its rate in the middle,
/// and its values anywhere on the range.
pub(super) fn wave(range: Interval, middle: f64, [value, rate, anywhere]: [Interval; 3]) -> Linear {
    let factor = rate.middle();
    let (point, around) = (Interval::point(middle), range - Interval::point(middle));
    let curve = -(anywhere * around.square() * Interval::point(0.5));
    let rounding = (rate - Interval::point(factor)) * around;
    Linear {
        factors: [factor, 0.0],
        remainder: value - Interval::point(factor) * point + rounding + curve,
    }
}
