//! Whether every joint holds by its definition, what rolls and what follows a cam among them.

use super::reading::Subject;
use mech_compiler::program::Position;
use mech_compiler::structure::{Factor, Rolling, RollingEnd};
use mech_test_support::judge::wrap;
use mech_test_support::{coordinate, factor, slip, worst_gap, worst_stretch};
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
    let slips = slips.filter_map(|rolling| slipped(subject, rolling, [&start, &poses]));
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
        let at = |poses: &[[f64; 4]]| coordinate(&subject.model, poses, motor.joint);
        let ((now, turns), (then, _)) = (at(&poses), at(&start));
        let gone = now - then - (value - first);
        let gone = if turns { wrap(gone) } else { gone / extent };
        off = off.max(gone.abs() / (1.0 + value.abs()));
    }
    (off > CLOSED).then(|| format!("a motor is off by {off:e}"))
}

/// How far two that roll on each other have slipped since the start, as far as their poses tell: whole turns of a wheel are not
/// in its pose. In units of the second's coordinate.
fn slipped(subject: &Subject, rolling: &Rolling, places: [&[[f64; 4]]; 2]) -> Option<f64> {
    let off = slip(&subject.model, rolling, places);
    let [(_, a), (second, b)] = rolling.ends;
    let (turn, unit) = match (a, b) {
        (Factor::Whole(m), Factor::Whole(n)) if matches!(second, RollingEnd::Wheel(_)) => {
            let common = u32::try_from(common(m.unsigned_abs(), n.unsigned_abs())).ok()?;
            (
                TAU * f64::from(common),
                factor(a).abs().max(factor(b).abs()),
            )
        }
        (Factor::Float(radius), Factor::Whole(_)) => (TAU * radius, 1.0),
        _ => return None,
    };
    Some((off - turn * (off / turn).round()).abs() / unit)
}

fn common(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { common(b, a % b) }
}
