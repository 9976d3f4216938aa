//! Numbers with as many digits as somebody would write.

use crate::bug::bug;

/// A number with so many decimal places, without zeros at its end.
pub(crate) fn round_to(value: f64, places: usize) -> f64 {
    // Zero added: there is no point in a negative one.
    read(&format!("{value:.places$}")) + 0.0
}

/// A number with so many digits; rounded upwards or downwards, if that is said.
pub(crate) fn significant(value: f64, digits: i32, upwards: Option<bool>) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    #[expect(clippy::cast_possible_truncation, reason = "a power of ten that numbers have")]
    let power = value.abs().log10().floor().clamp(-250.0, 250.0) as i32;
    let places = (digits - 1 - power).max(0);
    let scale = 10_f64.powi(places);
    let rounded = match upwards {
        None => value * scale,
        Some(true) => (value * scale).ceil(),
        Some(false) => (value * scale).floor(),
    };
    let Ok(places) = usize::try_from(places) else {
        bug!("a number has {places} decimal places");
    };
    round_to(rounded / scale, places)
}

/// A number with four digits.
pub(crate) fn of_four_digits(value: f64) -> f64 {
    read(&format!("{value:.3e}"))
}

/// A number with one digit.
pub(crate) fn of_one_digit(value: f64) -> f64 {
    read(&format!("{value:.0e}"))
}

fn read(text: &str) -> f64 {
    let Ok(value) = text.parse() else {
        bug!("`{text}` is no number");
    };
    value
}
