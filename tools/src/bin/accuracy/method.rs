//! The compared methods, in single and in double precision.

use std::fmt;

/// A method that solves the loops of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    /// `method exact;`
    Exact,
    /// `method linear;`
    Linear,
    /// `method newton(k);`
    Rounds(u8),
    /// `method newton;`
    Newton,
}

impl Method {
    /// All compared methods.
    pub(crate) const ALL: [Self; 6] = [
        Self::Exact,
        Self::Linear,
        Self::Rounds(1),
        Self::Rounds(2),
        Self::Rounds(3),
        Self::Newton,
    ];
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact => f.pad("exact"),
            Self::Linear => f.pad("linear"),
            Self::Rounds(rounds) => f.pad(&format!("newton({rounds})")),
            Self::Newton => f.pad("newton"),
        }
    }
}

/// A precision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Precision {
    /// `f32`
    Single,
    /// `f64`
    Double,
}

impl Precision {
    /// The nearest number that it has.
    #[expect(clippy::cast_possible_truncation, reason = "rounding is what is asked for")]
    pub(crate) fn round(self, value: f64) -> f64 {
        match self {
            Self::Single => f64::from(value as f32),
            Self::Double => value,
        }
    }
}

impl fmt::Display for Precision {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Single => "f32",
            Self::Double => "f64",
        })
    }
}
