//! Numbers of operations.

use core::fmt;
use core::iter::Sum;
use core::ops::{Add, Mul};

/// Numbers of operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Cost {
    /// Additions, subtractions and changes of sign.
    pub additions: u32,
    /// Multiplications.
    pub multiplications: u32,
    /// Divisions.
    pub divisions: u32,
    /// Square roots.
    pub square_roots: u32,
    /// Sines and cosines; both of one angle are one pair.
    pub sine_cosine_pairs: u32,
    /// Arctangents, and exponentials, which cost as much.
    pub arctangents: u32,
    /// Comparisons, and operations that cost no more: absolute values, maxima, copied signs, choices, roundings.
    pub selections: u32,
}

impl Cost {
    /// No operation.
    pub const NOTHING: Self = Self::of_counts([0; 7]);

    /// The number of each kind of operation, in the order of the fields.
    #[must_use]
    pub const fn counts(self) -> [u32; 7] {
        [
            self.additions,
            self.multiplications,
            self.divisions,
            self.square_roots,
            self.sine_cosine_pairs,
            self.arctangents,
            self.selections,
        ]
    }

    /// The cost with these numbers of operations.
    const fn of_counts(counts: [u32; 7]) -> Self {
        let [additions, multiplications, divisions, ..] = counts;
        let [.., square_roots, sine_cosine_pairs, arctangents, selections] = counts;
        Self {
            additions,
            multiplications,
            divisions,
            square_roots,
            sine_cosine_pairs,
            arctangents,
            selections,
        }
    }

    /// Combines the numbers of two costs, kind by kind.
    fn combine(self, other: Self, each: impl Fn(u32, u32) -> u32) -> Self {
        let mut counts = self.counts();
        for (count, other) in counts.iter_mut().zip(other.counts()) {
            *count = each(*count, other);
        }
        Self::of_counts(counts)
    }

    /// The difference to another cost, kind by kind, and not less than zero.
    #[must_use]
    pub fn without(self, other: Self) -> Self {
        self.combine(other, u32::saturating_sub)
    }
}

impl Add for Cost {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.combine(other, u32::saturating_add)
    }
}

impl Mul<u32> for Cost {
    type Output = Self;

    fn mul(self, times: u32) -> Self {
        Self::of_counts(self.counts().map(|count| count.saturating_mul(times)))
    }
}

impl Sum for Cost {
    fn sum<I: Iterator<Item = Self>>(costs: I) -> Self {
        costs.fold(Self::NOTHING, Add::add)
    }
}

impl fmt::Display for Cost {
    /// Writes the numbers with the signs of the operations: `12 + · 9 × · 1 √`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let signs = ["+", "×", "÷", "√", "sin cos", "atan", "≷"];
        let parts = self.counts().into_iter().zip(signs);
        let mut parts = parts.filter(|(count, _)| *count > 0);
        let Some((count, sign)) = parts.next() else {
            return f.write_str("nothing");
        };
        write!(f, "{count} {sign}")?;
        parts.try_for_each(|(count, sign)| write!(f, " · {count} {sign}"))
    }
}
