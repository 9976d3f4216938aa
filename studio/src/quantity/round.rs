//! Round numbers, for axes.

use std::ops::Range;

/// A round step that divides a range into about so many parts. Steps of angles divide a turn.
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

/// Four digits of a number.
pub(crate) fn four_digits(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
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
    use super::tick;

    #[test]
    fn numbers_are_short() {
        assert_eq!(tick(0.1 + 0.2), "0.3");
        assert_eq!(tick(-1e-17), "0");
        assert_eq!(tick(2.5e9), "2.5e9");
    }
}
