//! What is painted of a mechanism wherever its motors take it, beside the box that the compiler has for it.

use crate::Dice;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointKind, Measure, Model};
use mech_compiler::program::Position;
use mech_compiler::{Compiled, Looks, Points, looks};
use mech_runtime::{OwnedOutline, Pose};
use std::f64::consts::TAU;
use std::time::{Duration, Instant};

/// How far a motor that slides without a range is taken, in sizes of the mechanism, as the documentation of `EXTENT` says.
const SLIDE: f64 = 4.0;

/// What flies away is seen no farther than so many sizes of the mechanism beyond its start, but for rounding.
const LIMIT: f64 = 0.999 * 32.0;

/// A walk takes no longer than this: some mechanisms move in very small pieces.
const MOST: Duration = Duration::from_millis(500);

/// How far anything is painted outside of the box in so many random positions that motors can reach, as a part of the box's longer side.
/// Half of them are those of a walk, whose steps are mostly short. The others lie around those that were outermost on a side before: so
/// it climbs to where the motors take the mechanism farthest out.
#[must_use]
pub fn painted_outside(
    model: &Model,
    compiled: &Compiled,
    dice: &mut Dice,
    positions: usize,
) -> f64 {
    let looks = looks(model, compiled);
    let [low, high] = looks.extent(model, compiled);
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    let seen = places(&looks);
    let start = &compiled.program.start.motors;
    let range = |index: usize| {
        let motor = &model.motors[index];
        let reach = SLIDE * model.size();
        match (motor.range, model.joint(motor.joint).kind) {
            (Some(range), _) => [range.low, range.high],
            (None, JointKind::Revolute(..)) => [start[index] - TAU, start[index] + TAU],
            (None, _) => [start[index] - reach, start[index] + reach],
        }
    };
    let mut machine = Machine::<f64>::new(&compiled.program);
    let mut walked = machine.position().clone();
    let mut outermost: [_; 4] = std::array::from_fn(|_| (f64::NEG_INFINITY, walked.clone()));
    let begin = Instant::now();
    for number in 0..positions {
        if begin.elapsed() > MOST {
            break;
        }
        let climbs = number % 2 == 1;
        let part = match (climbs, dice.once_in(8)) {
            (true, _) => 10_f64.powf(dice.between(-4.0, -0.3)),
            (false, true) => 1.0,
            (false, false) => 0.1,
        };
        let from = if climbs { &outermost[dice.below(4)].1 } else { &walked };
        machine.put_back(from.clone());
        let mut target = from.motors.clone();
        let alone = dice.below(model.motors.len().max(1));
        let all = dice.once_in(2);
        let motors = target.iter_mut().enumerate().take(model.motors.len());
        for (index, value) in motors.filter(|(index, _)| all || *index == alone) {
            let [near, far] = range(index);
            let step = part * (dice.between(near, far) - 0.5 * (near + far));
            *value = (*value + step).clamp(near, far);
        }
        let _ = machine.move_toward(&target);
        let position = machine.position();
        if !climbs {
            walked = position.clone();
        }
        let sides = beyond(&seen, position, [low, high]);
        for (known, beyond) in outermost.iter_mut().zip(sides) {
            if beyond > known.0 {
                *known = (beyond, position.clone());
            }
        }
    }
    // How far within the box everything is at the start.
    let start = beyond(&seen, Machine::<f64>::new(&compiled.program).position(), [low, high]);
    let judged = outermost.iter().zip(start).filter(|(_, start)| -start < LIMIT * model.size());
    judged.map(|(known, _)| known.0).fold(0.0, f64::max) / size
}

/// How far anything is beyond each side of a box.
fn beyond(
    seen: &[(usize, [f64; 2], f64)],
    position: &Position<f64>,
    [low, high]: [[f64; 2]; 2],
) -> [f64; 4] {
    let mut sides = [f64::NEG_INFINITY; 4];
    for &(link, [u, v], radius) in seen {
        let pose = link.checked_sub(1).map(|link| position.poses[link].into());
        let at = pose.unwrap_or(Pose::identity()).apply([u, v]);
        for part in 0..2 {
            sides[part] = sides[part].max(low[part] - (at[part] - radius));
            sides[2 + part] = sides[2 + part].max(at[part] + radius - high[part]);
        }
    }
    sides
}

/// For each link that is painted, 0 for the ground and else its place among the poses and one more, points and how far paint reaches around.
fn places(looks: &Looks) -> Vec<(usize, [f64; 2], f64)> {
    let mut all = Vec::new();
    for painted in &looks.painted {
        let link = painted.link.index();
        match painted.outline.map(Measure::at_start, Points::at_start) {
            OwnedOutline::Circle { center, radius } | OwnedOutline::Ring { center, radius, .. } => {
                all.push((link, center, radius));
            }
            OwnedOutline::Polygon(corners) | OwnedOutline::Winding(corners) => {
                all.extend(corners.into_iter().map(|corner| (link, corner, 0.0)));
            }
            OwnedOutline::Line { points, width } => {
                all.extend(points.into_iter().map(|point| (link, point, 0.5 * width)));
            }
            OwnedOutline::Arc { center, start, angle, width } => {
                let [x, y] = [start[0] - center[0], start[1] - center[1]];
                all.extend((0..=24).map(|part| {
                    let (sin, cos) = (angle * f64::from(part) / 24.0).sin_cos();
                    let at = [center[0] + cos * x - sin * y, center[1] + sin * x + cos * y];
                    (link, at, 0.5 * width)
                }));
            }
        }
    }
    all
}
