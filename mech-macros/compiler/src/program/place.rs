//! Numbers of axes and shapes that depend on params.

use super::Program;
use crate::model::FormulaId;

/// A number that depends on params: of the place or direction of an axis in its link, or of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// How it is computed.
    pub formula: FormulaId,
    /// Where its value is kept.
    pub state: usize,
}

impl Program {
    /// Where what a formula gives is kept; none if nothing tells it.
    #[must_use]
    pub fn kept_number(&self, formula: FormulaId) -> Option<usize> {
        let mut places = self.places.iter();
        let found = places.find(|place| place.formula == formula);
        found.map(|place| place.state)
    }
}
