//! Numbers with as many digits as somebody would write.

use crate::bug::bug;

/// A number with so many decimal places, without zeros at its end.
pub(crate) fn round_to(value: f64, places: usize) -> f64 {
    // Zero added: there is no point in a negative one.
    read(&format!("{value:.places$}")) + 0.0
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
