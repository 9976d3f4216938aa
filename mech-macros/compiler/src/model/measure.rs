//! Numbers of what is drawn: constants of the generated code, or expressions where params change them.

use super::FormulaId;

/// A number of what is drawn: a share of another, which may depend on params.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Measure {
    /// The number of which it is a share, at the start.
    pub value: f64,
    /// The formula of that number, if it depends on params.
    pub formula: Option<FormulaId>,
    /// The share.
    pub share: f64,
}

/// A place in the frame of a link, in scene units.
pub type Place = [Measure; 2];

impl Measure {
    /// A number that does not change.
    pub(crate) fn fixed(value: f64) -> Self {
        Self::new(value, None)
    }

    /// A number that may depend on params.
    pub(crate) fn new(value: f64, formula: Option<FormulaId>) -> Self {
        let share = 1.0;
        Self { value, formula, share }
    }

    /// So many times this number.
    pub(crate) fn times(self, share: f64) -> Self {
        let share = self.share * share;
        Self { share, ..self }
    }

    /// The number at the start.
    #[must_use]
    pub fn at_start(self) -> f64 {
        self.share * self.value
    }
}
