//! The effects: results beyond positions.

use super::{AxisId, LinkId, Model, Origin};

/// The effects that were asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each effect is asked for or not, whatever the others"
)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Effects {
    /// Velocities of links, points and joints.
    pub velocity: bool,
    /// Their accelerations; only with velocities.
    pub acceleration: bool,
    /// Forces: what torques the motors need, and how the joints react.
    pub force: bool,
    /// Motion under the torques of the motors.
    pub dynamics: bool,
    /// The diagram: joint symbols, arrows.
    pub overlay: bool,
    /// The rates of links, points and joints for each param.
    pub sensitivity: bool,
}

impl Effects {
    /// Whether something has to be known of the masses of all links and of what acts on them.
    #[must_use]
    pub fn needs_actions(self) -> bool {
        self.force || self.dynamics
    }
}

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
