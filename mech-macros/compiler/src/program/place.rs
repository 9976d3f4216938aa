//! Where axes are in their links, if that depends on params.

use super::Program;
use crate::model::AxisId;

/// A coordinate of an axis in its link that depends on params.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The axis.
    pub axis: AxisId,
    /// Which of its coordinates: zero for the abscissa, one for the ordinate.
    pub part: usize,
    /// Where its value is kept.
    pub state: usize,
}

impl Program {
    /// Where a coordinate of an axis in its link is kept; none if it is a constant, or nothing tells it.
    #[must_use]
    pub fn kept_place(&self, axis: AxisId, part: usize) -> Option<usize> {
        let found = |place: &&Place| place.axis == axis && place.part == part;
        self.places.iter().find(found).map(|place| place.state)
    }
}
