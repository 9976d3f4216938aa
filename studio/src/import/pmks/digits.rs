//! Numbers to the base 64, as links of PMKS+ write them.

use super::query::Field;
use crate::document::Message;

const DIGITS: &str = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
/// The most digits of a number: more than 53 bits are not exact.
const MOST: usize = 8;
/// Numbers with decimals are written as thousandths.
const THOUSANDTHS: f64 = 1000.0;

pub(super) fn digit(letter: char) -> Option<u32> {
    let value = DIGITS.chars().position(|digit| digit == letter)?;
    u32::try_from(value).ok()
}

/// A whole number. One that begins with `0` is below zero.
pub(super) fn whole(field: &Field<'_>) -> Result<f64, Message> {
    let text = field.text();
    if text.is_empty() {
        return Err(field.wrong("a number is missing here"));
    }
    let (sign, digits) = match text.strip_prefix('0') {
        Some(digits) => (-1.0, digits),
        None => (1.0, text),
    };
    if digits.len() > MOST {
        return Err(field.wrong(format!("`{text}` is a number that is too large")));
    }
    let mut value = 0.0;
    for letter in digits.chars() {
        let digit = digit(letter);
        let digit = digit.ok_or_else(|| {
            field.wrong(format!("`{letter}` in `{text}` is no digit to the base 64"))
        })?;
        value = value * 64.0 + f64::from(digit);
    }
    // Zero has no sign.
    Ok(if value == 0.0 { value } else { sign * value })
}

pub(super) fn decimal(field: &Field<'_>) -> Result<f64, Message> {
    Ok(whole(field)? / THOUSANDTHS)
}

/// The flags in a digit, from the lowest bit on.
pub(super) fn flags(field: &Field<'_>) -> Result<[bool; 6], Message> {
    let mut letters = field.text().chars();
    let value = letters.next().and_then(digit);
    let value = value.filter(|_| letters.next().is_none());
    let value = value.ok_or_else(|| {
        let text = field.text();
        field.wrong(format!("`{text}` is no digit to the base 64"))
    })?;
    Ok(std::array::from_fn(|bit| value >> bit & 1 == 1))
}
