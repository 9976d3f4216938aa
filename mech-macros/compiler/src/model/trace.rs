//! Recorded paths of points.

use super::{AxisId, LinkId, Model, Origin};

/// The last places of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Trace {
    /// The point: of a moving link, and named.
    pub point: AxisId,
    /// The number of places that are recorded.
    pub length: usize,
    /// The plane it is drawn in, above the ground's shapes and below all others there; without, below all links.
    pub plane: Option<i32>,
    /// Its entry in the palette.
    pub color: u8,
    /// Where it was declared.
    pub origin: Origin,
}

impl Trace {
    /// The most places that can be recorded: they are part of the struct.
    pub const LONGEST: i32 = 1 << 14;
}

impl Model {
    /// The links whose points are traced.
    pub(crate) fn traced_links(&self) -> impl Iterator<Item = LinkId> + '_ {
        self.traces.iter().map(|trace| self.axis(trace.point).link)
    }
}
