//! What is painted of a mechanism wherever its motors take it, beside the box that the compiler has for it.

use crate::Dice;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointKind, Model};
use mech_compiler::{Compiled, Looks, Outline, looks};
use std::f64::consts::TAU;
use std::time::{Duration, Instant};

/// How far a motor that slides without a range is taken, in sizes of the mechanism, as the documentation of `EXTENT` says.
const SLIDE: f64 = 4.0;

/// A walk takes no longer than this: some mechanisms move in very small pieces.
const MOST: Duration = Duration::from_millis(500);

/// How far anything is painted outside of the box in so many random positions that motors can reach, as a part of the box's longer side.
/// They are those of a walk, whose steps are mostly short.
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
    let mut machine = Machine::<f64>::new(&compiled.program);
    let mut outside: f64 = 0.0;
    let begin = Instant::now();
    for number in 0..positions {
        if begin.elapsed() > MOST {
            break;
        }
        let alone = dice.below(model.motors.len().max(1));
        let mut target = machine.position().motors.clone();
        let part = if dice.once_in(8) { 1.0 } else { 0.1 };
        for (index, motor) in model.motors.iter().enumerate() {
            let reach = SLIDE * model.size();
            let [near, far] = match (motor.range, model.joint(motor.joint).kind) {
                (Some(range), _) => [range.low, range.high],
                (None, JointKind::Revolute(..)) => [start[index] - TAU, start[index] + TAU],
                (None, _) => [start[index] - reach, start[index] + reach],
            };
            if number % 2 == 0 || index == alone {
                let step = part * (dice.between(near, far) - 0.5 * (near + far));
                target[index] = (target[index] + step).clamp(near, far);
            }
        }
        let _ = machine.move_toward(&target);
        let poses = &machine.position().poses;
        for &(link, [u, v], radius) in &seen {
            let place = link.checked_sub(1).map(|link| poses[link]);
            let [cos, sin, x, y] = place.unwrap_or([1.0, 0.0, 0.0, 0.0]);
            let at = [x + cos * u - sin * v, y + sin * u + cos * v];
            for part in 0..2 {
                let beyond = (low[part] - (at[part] - radius)).max(at[part] + radius - high[part]);
                outside = outside.max(beyond / size);
            }
        }
    }
    outside
}

/// For each link that is painted, 0 for the ground and else its place among the poses and one more, points and how far paint reaches around.
fn places(looks: &Looks) -> Vec<(usize, [f64; 2], f64)> {
    let mut all = Vec::new();
    for painted in &looks.painted {
        let link = painted.link.index();
        let start =
            |place: &[mech_compiler::Measure; 2]| place.map(mech_compiler::Measure::at_start);
        match &painted.outline {
            Outline::Circle { center, radius } | Outline::Ring { center, radius, .. } => {
                all.push((link, start(center), radius.at_start()));
            }
            Outline::Polygon(corners) => {
                all.extend(corners.iter().map(|corner| (link, start(corner), 0.0)));
            }
            Outline::Line { points, width } => {
                let half = 0.5 * width.at_start();
                all.extend(points.iter().map(|point| (link, start(point), half)));
            }
            Outline::Arc {
                center,
                start,
                angle,
                width,
            } => {
                let [x, y] = [start[0] - center[0], start[1] - center[1]];
                all.extend((0..=24).map(|part| {
                    let (sin, cos) = (angle * f64::from(part) / 24.0).sin_cos();
                    let at = [center[0] + cos * x - sin * y, center[1] + sin * x + cos * y];
                    (link, at, 0.5 * width)
                }));
            }
            Outline::Toothed(wheel) => all.extend(
                wheel
                    .corners()
                    .into_iter()
                    .map(|corner| (link, corner, 0.0)),
            ),
        }
    }
    all
}
