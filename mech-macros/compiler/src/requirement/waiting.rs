//! Parts of all values that wait to be looked at, the least first, with the frames of their angles.

use crate::certify::Interval;
use crate::program::BlockId;
use std::rc::Rc;

/// Where angles over whole turns are counted from: valid at a place, and wherever they stay within half a turn on the way from there.
#[derive(Debug)]
pub(super) struct Frame {
    pub(super) references: Vec<f64>,
    pub(super) at: Vec<f64>,
    /// The loops that are on the other side there than at the start, as far as angles depend on that.
    pub(super) turned: Vec<BlockId>,
}

/// A part of all values.
pub(super) struct Part {
    pub(super) place: Vec<Interval>,
    /// Whether the loops have their sides there; else they may have.
    pub(super) is_sure: bool,
}

/// A part that waits, with a bound on what is least there.
pub(super) struct Waiting {
    pub(super) least: f64,
    pub(super) part: Part,
    pub(super) frame: Rc<Frame>,
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Waiting {}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Waiting {
    /// The least comes first.
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        other.least.total_cmp(&self.least)
    }
}
