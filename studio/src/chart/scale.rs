//! Axes of graphs, with round numbers at them.

use crate::quantity::round_step;
use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use std::ops::Range;

/// An axis: its range, and about how many numbers are written at it.
pub(super) struct Scale<'u> {
    range: Range<f64>,
    unit: &'u str,
    count: u32,
}

impl<'u> Scale<'u> {
    /// A scale from the least value to the greatest, with about so many numbers.
    pub(super) fn exact(values: impl Iterator<Item = f64>, unit: &'u str, count: u32) -> Self {
        Self { range: range_of(values), unit, count }
    }

    /// The same with some room at both ends.
    pub(super) fn with_room(values: impl Iterator<Item = f64>, unit: &'u str, count: u32) -> Self {
        let mut scale = Self::exact(values, unit, count);
        let length = scale.range.end - scale.range.start;
        scale.widen(1.1 * length);
        scale
    }

    /// Widens one of two axes, so that a unit is as long on both. They have these lengths, in pixels.
    pub(super) fn equalize(axes: [&mut Self; 2], pixels: [u32; 2]) {
        let [across, up] = axes;
        let [width, height] = pixels.map(f64::from);
        let of = |scale: &Self| scale.range.end - scale.range.start;
        let pixel = (of(across) / width).max(of(up) / height);
        across.widen(pixel * width);
        up.widen(pixel * height);
    }

    /// Gives its range another length, about the same middle.
    fn widen(&mut self, length: f64) {
        let middle = f64::midpoint(self.range.start, self.range.end);
        self.range = middle - 0.5 * length..middle + 0.5 * length;
    }

    /// Returns the number of labels on the axis.
    pub(super) fn count(&self) -> usize {
        self.ticks().len()
    }

    fn ticks(&self) -> Vec<f64> {
        ticks(&self.range, self.unit, self.count)
    }
}

impl Ranged for Scale<'_> {
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
        self.ticks()
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
    // Values that differ by rounding alone are shown as constant.
    let least = 1e-9 * low.abs().max(high.abs());
    if high - low > least {
        return low..high;
    }
    let room = low.abs().max(1.0) * 0.5;
    low - room..low + room
}

/// About so many round numbers in a range. For angles they divide a turn.
fn ticks(range: &Range<f64>, unit: &str, count: u32) -> Vec<f64> {
    let step = round_step(range, unit, count);
    let first = (range.start / step - 1e-9).ceil();
    let ticks = (0..=2 * count).map(|number| (first + f64::from(number)) * step);
    ticks.take_while(|tick| *tick <= range.end + 1e-9 * step).collect()
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
