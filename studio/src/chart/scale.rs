//! Axes of graphs, with round numbers at them.

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use std::ops::Range;

/// An axis: its range, and the numbers that are written at it.
pub(super) struct Scale {
    range: Range<f64>,
    ticks: Vec<f64>,
}

impl Scale {
    /// From the least value to the greatest, with about so many numbers.
    pub(super) fn exact(values: impl Iterator<Item = f64>, unit: &str, count: u32) -> Self {
        let range = range_of(values);
        let ticks = ticks(&range, unit, count);
        Self { range, ticks }
    }

    /// The same with some room at both ends.
    pub(super) fn with_room(values: impl Iterator<Item = f64>, unit: &str, count: u32) -> Self {
        let Range { start, end } = range_of(values);
        let room = 0.05 * (end - start);
        let range = start - room..end + room;
        let ticks = ticks(&range, unit, count);
        Self { range, ticks }
    }

    /// How many numbers are written at it.
    pub(super) fn count(&self) -> usize {
        self.ticks.len()
    }
}

impl Ranged for Scale {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (low, high): (i32, i32)) -> i32 {
        let part = (value - self.range.start) / (self.range.end - self.range.start);
        let place = f64::from(low) + part * f64::from(high - low);
        #[expect(clippy::cast_possible_truncation, reason = "saturates")]
        let pixel = place.round() as i32;
        pixel
    }

    fn key_points<H: KeyPointHint>(&self, _hint: H) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

/// From the least to the greatest value.
fn range_of(values: impl Iterator<Item = f64>) -> Range<f64> {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = values.fold(ends, |(low, high), value| (low.min(value), high.max(value)));
    if !low.is_finite() {
        // There is no value.
        return 0.0..1.0;
    }
    // What varies by rounding alone is shown as constant.
    let least = 1e-9 * low.abs().max(high.abs());
    if high - low > least {
        return low..high;
    }
    let room = low.abs().max(1.0) * 0.5;
    low - room..low + room
}

/// Round numbers in a range, about so many: of angles such as divide a turn.
fn ticks(range: &Range<f64>, unit: &str, count: u32) -> Vec<f64> {
    let step = round_step(range, unit, count);
    let first = (range.start / step - 1e-9).ceil();
    let ticks = (0..=2 * count).map(|number| (first + f64::from(number)) * step);
    ticks
        .take_while(|tick| *tick <= range.end + 1e-9 * step)
        .collect()
}

/// A round step through a range, about so often: of angles one that divides a turn.
pub(crate) fn round_step(range: &Range<f64>, unit: &str, count: u32) -> f64 {
    /// Steps of angles from a degree on.
    const ANGLES: [f64; 10] = [1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0];
    let least = (range.end - range.start) / f64::from(count);
    let decade = 10.0_f64.powf(least.log10().floor());
    let mut round = [1.0, 2.0, 5.0, 10.0].map(|digit| digit * decade).to_vec();
    if unit == "deg" && (1.0..=180.0).contains(&least) {
        round = ANGLES.to_vec();
    }
    let step = round.into_iter().find(|step| *step >= least);
    step.unwrap_or(10.0 * decade)
}

/// A number at an axis, without the digits that only rounding has put there.
pub(crate) fn tick(value: f64) -> String {
    let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
    let shown = if rounded.abs() < 1e-9 { 0.0 } else { rounded };
    if shown != 0.0 && !(1e-4..1e7).contains(&shown.abs()) {
        format!("{shown:e}")
    } else {
        format!("{shown}")
    }
}

#[cfg(test)]
mod tests {
    use super::{tick, ticks};

    #[test]
    fn angles_divide_a_turn() {
        let degrees = |end| ticks(&(0.0..end), "deg", 10);
        assert_eq!(degrees(360.0)[..3], [0.0, 45.0, 90.0]);
        assert_eq!(degrees(180.0)[..3], [0.0, 30.0, 60.0]);
        assert_eq!(ticks(&(0.0..360.0), "mm", 10)[..3], [0.0, 50.0, 100.0]);
        assert_eq!(ticks(&(-0.35..0.35), "mm", 6), [-0.2, 0.0, 0.2]);
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(tick(0.1 + 0.2), "0.3");
        assert_eq!(tick(-1e-17), "0");
        assert_eq!(tick(2.5e9), "2.5e9");
    }
}
