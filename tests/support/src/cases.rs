//! How many random cases a test tries, and which: what the environment asks for, so that long runs are the same tests.

use std::ops::Range;

/// The number in a variable of the environment.
///
/// # Panics
/// If there is something that is no number.
fn number(variable: &str) -> Option<u64> {
    let text = std::env::var(variable).ok()?;
    let number = text.parse().ok();
    Some(number.unwrap_or_else(|| panic!("{variable}={text} is no whole number")))
}

/// How many cases a test tries: as many as `MECH_CASES` says, or so many.
#[must_use]
pub fn cases(usual: u64) -> u64 {
    number("MECH_CASES").unwrap_or(usual)
}

/// So many seeds, from that on which `MECH_SEED` says, or from 0 on.
#[must_use]
pub fn seeds(count: u64) -> Range<u64> {
    let first = number("MECH_SEED").unwrap_or(0);
    first..first.saturating_add(count)
}
