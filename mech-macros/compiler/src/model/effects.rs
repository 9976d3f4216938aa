//! The effects: results beyond positions.

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
