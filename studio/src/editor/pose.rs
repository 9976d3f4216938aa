//! Poses in the drawing.

/// A pose in scene units.
pub(crate) type Pose = mech_runtime::Pose<f64>;

/// The pose of the scene itself.
pub(crate) const SCENE: Pose = Pose {
    cos: 1.0,
    sin: 0.0,
    x: 0.0,
    y: 0.0,
};
