//! Axes of graphs, with round numbers at them.

use crate::quantity::round_step;
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

#[cfg(test)]
mod tests {
    use super::ticks;

    #[test]
    fn angles_divide_a_turn() {
        let degrees = |end| ticks(&(0.0..end), "deg", 10);
        assert_eq!(degrees(360.0)[..3], [0.0, 45.0, 90.0]);
        assert_eq!(degrees(180.0)[..3], [0.0, 30.0, 60.0]);
        assert_eq!(ticks(&(0.0..360.0), "mm", 10)[..3], [0.0, 50.0, 100.0]);
        assert_eq!(ticks(&(-0.35..0.35), "mm", 6), [-0.2, 0.0, 0.2]);
    }
}
