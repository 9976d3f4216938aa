//! How well a position satisfies its joints, straight from their definition.

use mech_compiler::model::{AxisId, JointKind, Model};

/// Where an axis is in the scene, and where it points. `poses` are the cosine, sine, x and y of every link, the ground
/// first.
fn placed(model: &Model, poses: &[[f64; 4]], id: AxisId) -> ([f64; 2], [f64; 2]) {
    let axis = model.axis(id);
    let [cos, sin, x, y] = poses[axis.link.index()];
    let turned = |[a, b]: [f64; 2]| [cos * a - sin * b, sin * a + cos * b];
    let [u, v] = turned(axis.at);
    ([x + u, y + v], turned(axis.direction))
}

/// The greatest distance between axes that should coincide, in scene units; for sliding axes also the sine of the angle
/// between them.
#[must_use]
pub fn worst_gap(model: &Model, poses: &[[f64; 4]]) -> f64 {
    let gap = |kind: &JointKind| match *kind {
        JointKind::Revolute(a, b) => {
            let (([a, b], _), ([c, d], _)) = (placed(model, poses, a), placed(model, poses, b));
            (c - a).hypot(d - b)
        }
        JointKind::Prismatic(a, b) => {
            let ((from, along), (to, other)) = (placed(model, poses, a), placed(model, poses, b));
            let across = along[0] * (to[1] - from[1]) - along[1] * (to[0] - from[0]);
            let askew = along[0] * other[1] - along[1] * other[0];
            across.abs().max(askew.abs())
        }
        JointKind::Weld(a, b) => {
            let ((from, along), (to, other)) = (placed(model, poses, a), placed(model, poses, b));
            let askew = along[0] * other[1] - along[1] * other[0];
            (to[0] - from[0]).hypot(to[1] - from[1]).max(askew.abs())
        }
        // What rolls is held to its ratio by tests of its own.
        JointKind::Gear { .. }
        | JointKind::Belt { .. }
        | JointKind::Rack { .. }
        | JointKind::Cam { .. } => 0.0,
    };
    model
        .joints
        .iter()
        .map(|joint| gap(&joint.kind))
        .fold(0.0, f64::max)
}

/// The greatest error of a link's length: how far its direction is from a unit vector.
#[must_use]
pub fn worst_stretch(poses: &[[f64; 4]]) -> f64 {
    poses
        .iter()
        .map(|[cos, sin, ..]| (cos.hypot(*sin) - 1.0).abs())
        .fold(0.0, f64::max)
}

/// All poses: the ground's, those of the declared links, and those of dies, which are where their pin is and point where
/// their slot does.
#[must_use]
pub fn with_ground(model: &Model, declared: &[[f64; 4]]) -> Vec<[f64; 4]> {
    let mut poses = vec![[1.0, 0.0, 0.0, 0.0]];
    poses.extend_from_slice(declared);
    for (pin, guide) in model.links.iter().filter_map(|link| link.die) {
        let ([x, y], _) = placed(model, &poses, pin);
        let (_, [cos, sin]) = placed(model, &poses, guide);
        poses.push([cos, sin, x, y]);
    }
    poses
}

/// The greatest distance of an axis from the origin of its link: the size of the mechanism.
#[must_use]
pub fn size(model: &Model) -> f64 {
    model
        .axes
        .iter()
        .map(|axis| axis.at[0].hypot(axis.at[1]))
        .fold(0.0, f64::max)
}
