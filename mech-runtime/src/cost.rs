//! The cost of a position.

use core::fmt;

/// The number of operations that a position takes, as generated. An operation whose result is never needed is not counted. An iteration
/// counts once for each round. Where a loop iterates until it closes, three rounds are counted.
///
/// ```
/// mech_runtime::mechanism! {
///     struct Crank;
///     link crank { point pin = (0, 1); }
///     joint a = revolute(ground, crank) at (0, 0);
///     motor a;
/// }
/// assert_eq!(Crank::COST.sine_cosine_pairs, 1);
/// assert_eq!(Crank::LOOP_COSTS, []);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
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
    pub const NOTHING: Self = Self {
        additions: 0,
        multiplications: 0,
        divisions: 0,
        square_roots: 0,
        sine_cosine_pairs: 0,
        arctangents: 0,
        selections: 0,
    };
}

impl fmt::Display for Cost {
    /// Writes the numbers with the signs of the operations: `12 + · 9 × · 1 √`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = [
            (self.additions, "+"),
            (self.multiplications, "×"),
            (self.divisions, "÷"),
            (self.square_roots, "√"),
            (self.sine_cosine_pairs, "sin cos"),
            (self.arctangents, "atan"),
            (self.selections, "≷"),
        ];
        let mut parts = parts.into_iter().filter(|(count, _)| *count > 0);
        let Some((count, sign)) = parts.next() else {
            return f.write_str("nothing");
        };
        write!(f, "{count} {sign}")?;
        parts.try_for_each(|(count, sign)| write!(f, " · {count} {sign}"))
    }
}
