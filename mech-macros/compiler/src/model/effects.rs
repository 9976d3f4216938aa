//! What is computed beyond positions.

/// The effects that were asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effects {
    /// Velocities of links, points and joints.
    pub velocity: bool,
    /// Their accelerations; only with velocities.
    pub acceleration: bool,
    /// How links, points and joints follow the params.
    pub sensitivity: bool,
}
