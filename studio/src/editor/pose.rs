//! Poses in the drawing.

/// A pose: cosine, sine, x and y.
pub(crate) type Pose = [f64; 4];

/// The pose of the scene itself.
pub(crate) const SCENE: Pose = [1.0, 0.0, 0.0, 0.0];

/// A place in the frame of a pose, in the scene.
pub(crate) fn apply([cos, sin, left, up]: Pose, [x, y]: [f64; 2]) -> [f64; 2] {
    [left + cos * x - sin * y, up + sin * x + cos * y]
}

/// A place of the scene in the frame of a pose.
pub(crate) fn relative([cos, sin, left, up]: Pose, [x, y]: [f64; 2]) -> [f64; 2] {
    let [x, y] = [x - left, y - up];
    [cos * x + sin * y, cos * y - sin * x]
}
