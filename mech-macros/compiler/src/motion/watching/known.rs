//! The proofs about loops.

use crate::certify::Interval;

/// The proof about a loop in closed form, if there is one.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct LoopProof {
    /// Where it always closes, and stays clear of its dead points and change points.
    pub(crate) free: Option<Free>,
}

/// A loop that always closes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Free {
    /// Its sine is never less than this.
    pub(crate) least_sine: f64,
    /// All values of what it finds: the angles of its directions in radians, its ways in scene units.
    pub(crate) ranges: Vec<Option<Interval>>,
    /// The least square of the distance of the pins that two circles are drawn about, as a part of the product of their radii.
    pub(crate) least_distance_square: f64,
}

impl LoopProof {
    /// All values of what the loop finds, by number, if they are known.
    pub(crate) fn range(&self, index: usize) -> Option<Interval> {
        let free = self.free.as_ref()?;
        free.ranges.get(index).copied().flatten()
    }
}
