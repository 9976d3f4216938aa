//! Random numbers from a seed, so that every failure can be repeated; and how many random cases a test tries, and which: what the
//! environment asks for, so that long runs are the same tests.

use std::ops::Range;

/// A small generator (splitmix64).
#[derive(Clone, Debug)]
pub struct Dice(u64);

impl Dice {
    /// The sequence of this seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Any number.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number below `end`, which is not zero.
    pub fn below(&mut self, end: usize) -> usize {
        usize::try_from(self.bits() >> 33).unwrap_or(0) % end
    }

    /// A number between `low` and `high`.
    #[expect(clippy::cast_precision_loss, reason = "53 random bits are enough")]
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// One of these.
    pub fn pick<'a, T>(&mut self, from: &'a [T]) -> &'a T {
        &from[self.below(from.len())]
    }

    /// True once in `times`.
    pub fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }
}

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
