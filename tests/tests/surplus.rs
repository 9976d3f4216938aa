//! More motors than needed lead a point: they go as little as they can, beside all other ways to be there.

use super::inverse::{Gantry, Snake};
use mech_runtime::Cause;
use mech_test_support::{Dice, cases};
use std::f64::consts::{PI, TAU};

/// The place of the snake's tip, by its angles alone: its links are 2, 1, and from (0, 0) to (1, 1) long.
fn snake_tip([a, b, c]: [f64; 3]) -> [f64; 2] {
    let (second, third) = (a + b, a + b - c + PI / 4.0);
    let last = 2_f64.sqrt();
    [
        2.0 * a.cos() + second.cos() + last * third.cos(),
        2.0 * a.sin() + second.sin() + last * third.sin(),
    ]
}

/// The motors of the snake near these at which its tip is at a place, for one of them: by bisecting the circle of the others.
fn snake_with(a: f64, near: [f64; 3], [x, y]: [f64; 2]) -> Option<[f64; 3]> {
    let [x, y] = [x - 2.0 * a.cos(), y - 2.0 * a.sin()];
    let (last, far) = (2_f64.sqrt(), x.hypot(y));
    // By the law of cosines, on both sides.
    let cosine = (far * far - 1.0 - last * last) / (2.0 * last);
    let bend = (cosine.abs() <= 1.0).then(|| cosine.acos())?;
    let solutions = [bend, -bend].map(|bend| {
        let second = y.atan2(x) - (last * bend.sin()).atan2(1.0 + last * bend.cos());
        let near_to = |value: f64, other: f64| value + TAU * ((other - value) / TAU).round();
        [a, near_to(second - a, near[1]), near_to(PI / 4.0 - bend, near[2])]
    });
    let far = |one: &[f64; 3]| (one[1] - near[1]).abs() + (one[2] - near[2]).abs();
    solutions.into_iter().min_by(|one, other| far(one).total_cmp(&far(other)))
}

#[test]
fn more_motors_than_needed_go_as_little_as_they_can() {
    let angles = |snake: &Snake| {
        let [b, a, c] = snake.motors();
        [a, b, c]
    };
    let mut snake = Snake::new();
    let mut dice = Dice::new(11);
    let mut arrived = 0;
    for round in 0..cases(400) {
        let before = angles(&snake);
        let [x, y] = snake_tip(before);
        let tip = snake.third_tip();
        assert!((tip.x - x).hypot(tip.y - y) < 1e-13);
        let far = if round % 4 == 0 { 1.5 } else { 0.2 };
        let goal = [x + dice.between(-far, far), y + dice.between(-far, far)];
        let still = snake;
        if snake.reach(goal).is_err() {
            assert_eq!(snake, still);
            // Its links reach so far.
            assert!(goal[0].hypot(goal[1]) > 4.2 || far > 1.0, "{goal:?}");
            continue;
        }
        arrived += 1;
        let after = angles(&snake);
        let tip = snake_tip(after);
        assert!((tip[0] - goal[0]).hypot(tip[1] - goal[1]) < 1e-13, "{goal:?}");
        // Where it is nearly stretched out, a way is made in pieces.
        if far > 1.0 || goal[0].hypot(goal[1]) > 4.0 {
            continue;
        }
        // Of all ways to be there with another angle of the first link, none is shorter.
        let length = |angles: [f64; 3]| {
            let gone = [0, 1, 2].map(|motor| angles[motor] - before[motor]);
            gone.iter().map(|gone| gone * gone).sum::<f64>()
        };
        let least = length(after);
        for step in -200..=200 {
            let a = after[0] + f64::from(step) * 1e-3;
            let Some(other) = snake_with(a, after, goal) else {
                continue;
            };
            assert!(length(other) > least - 1e-9, "{goal:?}: {other:?}, not {after:?}");
        }
    }
    assert!(10 * arrived > 8 * cases(400), "{arrived}");
}

#[test]
fn the_least_rates_are_those_of_the_pseudoinverse() {
    const STEP: f64 = 1e-6;
    let mut snake = Snake::new();
    assert_eq!(snake.reach_with([2.5, 2.0], [0.3, -0.4], [0.1, 0.2]), Ok(()));
    let (velocity, acceleration) = (snake.third_tip_velocity(), snake.third_tip_acceleration());
    assert!((velocity.x - 0.3).hypot(velocity.y + 0.4) < 1e-13);
    assert!((acceleration.x - 0.1).hypot(acceleration.y - 0.2) < 1e-12);
    let [b, a, c] = snake.motors();
    let here = [a, b, c];
    let jacobian = nalgebra::Matrix2x3::from_fn(|row, column| {
        let [before, after] = [-STEP, STEP].map(|step| {
            let mut angles = here;
            angles[column] += step;
            snake_tip(angles)[row]
        });
        (after - before) / (2.0 * STEP)
    });
    let inverse = jacobian.pseudo_inverse(1e-12).expect("it has one");
    let rates = inverse * nalgebra::Vector2::new(0.3, -0.4);
    let found = [snake.a_rate(), snake.b_rate(), snake.c_rate()];
    for motor in 0..3 {
        assert!((rates[motor] - found[motor]).abs() < 1e-8, "{rates} {found:?}");
    }
}

#[test]
fn a_motor_at_the_end_of_its_range_lets_others_go_on() {
    let mut gantry = Gantry::new();
    let start = gantry;
    // Farther than the carriage goes, at the same angle.
    for step in 1..=22 {
        let far = 0.05 * f64::from(step);
        let reached = gantry.reach([far, 0.1 * far, 0.0]);
        assert_eq!(reached, Ok(()), "{far}");
        let pose = gantry.hand();
        let off = (pose.translation.x - far).hypot(pose.translation.y - 0.1 * far);
        assert!(off.max(pose.rotation.angle().abs()) < 1e-13, "{far}: {off:e}");
        let [slide, _, elbow, _] = gantry.motors();
        assert!((-0.5..=0.5).contains(&slide), "{slide}");
        assert!((-30_f64.to_radians()..=100_f64.to_radians()).contains(&elbow));
    }
    assert_eq!(gantry.motors()[0], 0.5);
    let there = gantry;
    let blocked = gantry.reach([9.0, 0.0, 0.0]).expect_err("it is too far");
    assert_eq!(gantry, there);
    // Its wrist goes as far from the shoulder as both links are long together.
    let [x, y, _] = blocked.reached;
    let (far, links) = ((2.5 + x).hypot(1.0 + y), 3.25_f64.sqrt() + 4.25_f64.sqrt());
    assert!(far < links && far > links - 3e-3, "{blocked}");
    assert_eq!(blocked.cause, Cause::Open, "{blocked}");
    assert_ne!(gantry, start);
}
