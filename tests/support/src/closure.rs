//! How well a position satisfies its joints, straight from their definition.

use crate::judge::wrap;
use mech_compiler::model::{AxisId, JointId, JointKind, Law, LinkId, Model};
use mech_compiler::structure::{Factor, Rolling, RollingEnd};
use std::f64::consts::TAU;

/// Where an axis is in the scene, and where it points. `poses` are the cosine, sine, x and y of every link, the ground
/// first.
fn locate(model: &Model, poses: &[[f64; 4]], id: AxisId) -> ([f64; 2], [f64; 2]) {
    let axis = model.axis(id);
    let [cos, sin, x, y] = poses[axis.link.index()];
    let turned = |[a, b]: [f64; 2]| [cos * a - sin * b, sin * a + cos * b];
    let [u, v] = turned(axis.at);
    ([x + u, y + v], turned(axis.direction))
}

/// The greatest distance between axes that should coincide, in scene units; for sliding axes also the sine of the angle
/// between them; and how far the followers of cams are from where they should be.
#[must_use]
pub fn worst_gap(model: &Model, poses: &[[f64; 4]]) -> f64 {
    let gap = |kind: &JointKind| match *kind {
        JointKind::Revolute(a, b) => {
            let (([a, b], _), ([c, d], _)) = (locate(model, poses, a), locate(model, poses, b));
            (c - a).hypot(d - b)
        }
        JointKind::Prismatic(a, b) => {
            let ((from, along), (to, other)) = (locate(model, poses, a), locate(model, poses, b));
            let across = along[0] * (to[1] - from[1]) - along[1] * (to[0] - from[0]);
            let askew = along[0] * other[1] - along[1] * other[0];
            across.abs().max(askew.abs())
        }
        JointKind::Weld(a, b) => {
            let ((from, along), (to, other)) = (locate(model, poses, a), locate(model, poses, b));
            let askew = along[0] * other[1] - along[1] * other[0];
            (to[0] - from[0]).hypot(to[1] - from[1]).max(askew.abs())
        }
        // What rolls is held to its ratio by `slip`.
        JointKind::Gear { .. } | JointKind::Belt { .. } | JointKind::Rack { .. } => 0.0,
        JointKind::Cam { shaft, follower, law } => {
            off_cam(model, poses, [shaft, follower], model.law(law))
        }
    };
    model.joints.iter().map(|joint| gap(&joint.kind)).fold(0.0, f64::max)
}

/// How far a follower is from where the law of its cam has it: angles less whole turns. A law that is another in every turn of
/// its shaft is left to other tests.
fn off_cam(model: &Model, poses: &[[f64; 4]], joints: [JointId; 2], law: &Law) -> f64 {
    let [(shaft, turns), (follower, is_angle)] = joints.map(|id| coordinate(model, poses, id));
    let winding = law.winding();
    let same = if is_angle {
        winding.is_some_and(|turns| turns.fract() == 0.0)
    } else {
        winding == Some(0.0)
    };
    if turns && !same {
        return 0.0;
    }
    let off = follower - model.at_start(law, shaft);
    if is_angle { off - TAU * (off / TAU).round() } else { off }.abs()
}

/// By how much two that roll on each other have slipped between two places: the sum of what their ends have moved by, times their factors.
/// Links turn by less than half a turn, or it is known but for their whole turns.
#[must_use]
pub fn slip(model: &Model, rolling: &Rolling, [before, now]: [&[[f64; 4]]; 2]) -> f64 {
    let turned = |link: LinkId| {
        let [a, b] = [before, now].map(|poses| poses[link.index()]);
        wrap(b[1].atan2(b[0]) - a[1].atan2(a[0]))
    };
    let moved = |end| match end {
        RollingEnd::Wheel(wheel) => turned(wheel) - turned(rolling.carrier),
        RollingEnd::Bar { slide, forwards, .. } => {
            let [then, now] = [before, now].map(|poses| coordinate(model, poses, slide).0);
            if forwards { now - then } else { then - now }
        }
    };
    rolling.ends.map(|(end, by)| factor(by) * moved(end)).iter().sum()
}

/// A number of teeth, or a radius.
///
/// # Panics
/// If there are too many teeth.
#[must_use]
pub fn factor(factor: Factor) -> f64 {
    match factor {
        Factor::Whole(value) => f64::from(i32::try_from(value).expect("few teeth")),
        Factor::Float(value) => value,
    }
}

/// The coordinate of a joint, and whether it is an angle: then between −π and π.
#[must_use]
pub fn coordinate(model: &Model, poses: &[[f64; 4]], id: JointId) -> (f64, bool) {
    match model.joint(id).kind {
        JointKind::Revolute(a, b) => {
            let ((_, [c, s]), (_, [d, t])) = (locate(model, poses, a), locate(model, poses, b));
            ((c * t - s * d).atan2(c * d + s * t), true)
        }
        JointKind::Prismatic(a, b) => {
            let ((from, along), (to, _)) = (locate(model, poses, a), locate(model, poses, b));
            let slide = along[0] * (to[0] - from[0]) + along[1] * (to[1] - from[1]);
            (slide, false)
        }
        _ => (0.0, false),
    }
}

/// The greatest error of a link's length: how far its direction is from a unit vector.
#[must_use]
pub fn worst_stretch(poses: &[[f64; 4]]) -> f64 {
    poses.iter().map(|[cos, sin, ..]| (cos.hypot(*sin) - 1.0).abs()).fold(0.0, f64::max)
}

/// All poses: the ground's, those of the declared links, and those of dies, which are where their pin is and point where
/// their slot does.
#[must_use]
pub fn with_ground(model: &Model, declared: &[[f64; 4]]) -> Vec<[f64; 4]> {
    let mut poses = vec![[1.0, 0.0, 0.0, 0.0]];
    poses.extend_from_slice(declared);
    for (pin, guide) in model.links.iter().filter_map(|link| link.die) {
        let ([x, y], _) = locate(model, &poses, pin);
        let (_, [cos, sin]) = locate(model, &poses, guide);
        poses.push([cos, sin, x, y]);
    }
    poses
}

/// The greatest distance of an axis from the origin of its link: the size of the mechanism.
#[must_use]
pub fn size(model: &Model) -> f64 {
    model.axes.iter().map(|axis| axis.at[0].hypot(axis.at[1])).fold(0.0, f64::max)
}
