//! Whether every joint holds by its definition, what rolls and what follows a cam among them.

use super::reading::Subject;
use mech_compiler::model::{JointId, JointKind};
use mech_compiler::program::Position;
use mech_compiler::structure::{Factor, Rolling, RollingEnd};
use mech_test_support::judge::wrap;
use mech_test_support::{worst_gap, worst_stretch};
use std::f64::consts::TAU;

/// A gap of this part of the extent is none.
const CLOSED: f64 = 1e-9;

/// What does not hold at a position.
pub(crate) fn fault(subject: &Subject, at: &Position<f64>) -> Option<String> {
    let poses = subject.poses(at);
    let numbers = poses.iter().flatten().chain(&at.motors).chain(&at.state);
    if numbers.into_iter().any(|number| !number.is_finite()) {
        return Some("something is not finite".to_owned());
    }
    let extent = subject.extent(&poses);
    let gap = worst_gap(&subject.model, &poses);
    if gap > CLOSED * extent {
        return Some(format!("a gap of {gap:e} at an extent of {extent}"));
    }
    let stretch = worst_stretch(&poses);
    if stretch > 1e-12 {
        return Some(format!("a link is stretched by {stretch:e}"));
    }
    let start = subject.poses(&subject.compiled.program.start);
    let slips = subject.compiled.structure.rollings.iter();
    let slips = slips.filter_map(|rolling| slip(subject, rolling, [&start, &poses]));
    let worst = slips.fold(0.0, f64::max);
    if worst > CLOSED * extent.max(1.0) {
        return Some(format!("what rolls has slipped by {worst:e}"));
    }
    let turned = subject
        .model
        .motors
        .iter()
        .zip(&at.motors)
        .zip(&subject.compiled.program.start.motors);
    let mut off = 0.0_f64;
    for ((motor, value), first) in turned {
        let now = coordinate(subject, motor.joint, &poses);
        let then = coordinate(subject, motor.joint, &start);
        let gone = now - then - (value - first);
        let slides = matches!(
            subject.model.joint(motor.joint).kind,
            JointKind::Prismatic(..)
        );
        let gone = if slides { gone / extent } else { wrap(gone) };
        off = off.max(gone.abs() / (1.0 + value.abs()));
    }
    (off > CLOSED).then(|| format!("a motor is off by {off:e}"))
}

/// The coordinate of a joint but for a constant: an angle but for whole turns.
fn coordinate(subject: &Subject, joint: JointId, poses: &[[f64; 4]]) -> f64 {
    let model = &subject.model;
    let pose = |axis| poses[model.axis(axis).link.index()];
    let turned =
        |[cos, sin, ..]: [f64; 4], [a, b]: [f64; 2]| [cos * a - sin * b, sin * a + cos * b];
    match model.joint(joint).kind {
        JointKind::Revolute(a, b) => angle(pose(b)) - angle(pose(a)),
        JointKind::Prismatic(a, b) => {
            let (p, q) = (pose(a), pose(b));
            let (from, to) = (turned(p, model.axis(a).at), turned(q, model.axis(b).at));
            let along = turned(p, model.axis(a).direction);
            along[0] * (q[2] + to[0] - p[2] - from[0]) + along[1] * (q[3] + to[1] - p[3] - from[1])
        }
        _ => 0.0,
    }
}

fn angle([cos, sin, ..]: [f64; 4]) -> f64 {
    sin.atan2(cos)
}

/// How far two that roll on each other have slipped since the start, as far as their poses tell: whole turns of a wheel are not
/// in its pose. In units of the second's coordinate.
fn slip(subject: &Subject, rolling: &Rolling, [start, poses]: [&[[f64; 4]]; 2]) -> Option<f64> {
    let carrier = rolling.carrier.index();
    let moved = |end: RollingEnd| match end {
        RollingEnd::Wheel(wheel) => {
            let own = |poses: &[[f64; 4]]| angle(poses[wheel.index()]) - angle(poses[carrier]);
            own(poses) - own(start)
        }
        RollingEnd::Bar {
            slide, forwards, ..
        } => {
            let displacement =
                coordinate(subject, slide, poses) - coordinate(subject, slide, start);
            if forwards {
                displacement
            } else {
                -displacement
            }
        }
    };
    let [(first, a), (second, b)] = rolling.ends;
    match (a, b) {
        (Factor::Whole(a), Factor::Whole(b)) if matches!(second, RollingEnd::Wheel(_)) => {
            let (a, b) = (i32::try_from(a).ok()?, i32::try_from(b).ok()?);
            let off = f64::from(a) * moved(first) + f64::from(b) * moved(second);
            let turn = TAU * f64::from(common(a.unsigned_abs(), b.unsigned_abs()));
            Some((off - turn * (off / turn).round()).abs() / f64::from(a.abs().max(b.abs())))
        }
        (Factor::Float(radius), Factor::Whole(_)) => {
            let off = radius * moved(first) - moved(second);
            let turn = TAU * radius;
            Some((off - turn * (off / turn).round()).abs())
        }
        _ => None,
    }
}

fn common(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { common(b, a % b) }
}
