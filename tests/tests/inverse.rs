//! Points that are led: after each `reach` every joint holds as it was declared, motors are where their joints are, and the point is
//! where it was asked to be.

use mech_runtime::{Blocked, Cause, JointKind, Mechanism, Pose};
use mech_test_support::{Dice, cases};
use std::f64::consts::{PI, TAU};

include!(concat!(env!("OUT_DIR"), "/inverse.rs"));

/// A mechanism whose point can be led.
trait Follower: Mechanism<Scalar = f64> + Copy + PartialEq + std::fmt::Debug {
    const POINT: (&'static str, [f64; 2]);
    fn lead(&mut self, place: &[f64]) -> Result<(), Blocked<Vec<f64>>>;
    fn set(&mut self, motors: &[f64]) -> bool;
}

macro_rules! follower {
    ($name:ident, $motors:literal, $given:literal, $link:literal, $at:expr) => {
        impl Follower for $name {
            const POINT: (&'static str, [f64; 2]) = ($link, $at);

            fn lead(&mut self, place: &[f64]) -> Result<(), Blocked<Vec<f64>>> {
                let place: [f64; $given] = place.try_into().expect("as many as are given");
                self.reach(place).map_err(|blocked| blocked.map(Vec::from))
            }

            fn set(&mut self, motors: &[f64]) -> bool {
                let motors: [f64; $motors] = motors.try_into().expect("a value each");
                self.move_to(motors).is_ok()
            }
        }
    };
}

follower!(Plotter, 2, 2, "pen", [2.5, 0.0]);
follower!(Scara, 2, 2, "forearm", [3.0, 1.0]);
follower!(Excavator, 3, 3, "bucket", [5.0, -0.8]);
follower!(Pantograph, 2, 2, "c", [4.0, 0.0]);
follower!(Platform, 3, 3, "platform", [3.0, 1.6]);

fn pose_of<M: Follower>(mechanism: &M) -> Pose<f64> {
    let number = M::LINKS.iter().position(|link| *link == M::POINT.0);
    mechanism.poses()[number.expect("it is a link")]
}

/// The place of the point, and the angle of its link.
fn place<M: Follower>(mechanism: &M) -> [f64; 3] {
    let pose = pose_of(mechanism);
    let [x, y] = pose.apply(M::POINT.1);
    [x, y, pose.sin.atan2(pose.cos)]
}

/// By how much joints and motors are not as they were declared: lengths, and angles up to whole turns, as parts of a value of many radians,
/// which is rounded to so much less.
fn misfit<M: Follower>(mechanism: &M) -> f64
where
    M::Motors: AsRef<[f64]>,
{
    let motors = mechanism.motors();
    let mut worst: f64 = 0.0;
    for joint in M::JOINTS {
        let Some(anchors) = joint.anchors else {
            continue;
        };
        let [a, b] = anchors.map(|anchor| {
            let link = anchor.link.expect("all poses are known");
            let pose = Pose::of_link(link, mechanism.poses()).expect("it has a pose");
            (pose.apply(anchor.at), pose.turn(anchor.along))
        });
        let [x, y] = [b.0[0] - a.0[0], b.0[1] - a.0[1]];
        let sine = a.1[0] * b.1[1] - a.1[1] * b.1[0];
        let cosine = a.1[0] * b.1[0] + a.1[1] * b.1[1];
        let value = joint.motor.map(|motor| motors.as_ref()[motor]);
        let parts = match joint.kind {
            JointKind::Revolute => {
                let turned = value.map(|value| (value - sine.atan2(cosine)) / TAU);
                let turned = turned.map(|turned| TAU * (turned - turned.round()));
                [x, y, turned.unwrap_or(0.0) / value.map_or(1.0, |value| value.abs().max(1.0))]
            }
            JointKind::Prismatic => {
                let along = x * a.1[0] + y * a.1[1];
                let slid = value.map(|value| value - along);
                [x * a.1[1] - y * a.1[0], sine, slid.unwrap_or(0.0)]
            }
            _ => continue,
        };
        worst = parts.iter().fold(worst, |worst, part| worst.max(part.abs()));
    }
    worst
}

/// Leads a point to random places, each as far from the last as `far` says, and moves motors in between. Whether a way is free is said
/// by `is_free`; where it is, the point must come there. Rounding of lengths and of the motors' values moves it by what they are divided
/// by: `sine`, that of a loop.
fn lead<M: Follower>(
    far: [f64; 3],
    stir: f64,
    is_free: impl Fn(&[f64; 3], &[f64; 3]) -> bool,
    mut sine: impl FnMut(&M) -> f64,
) where
    M::Motors: AsRef<[f64]>,
{
    let count = if M::POINT.0 == "c" || M::MOTORS.len() == 2 { 2 } else { 3 };
    let (mut arrived, mut refused, mut worst) = (0, 0, 0.0_f64);
    let mut dice = Dice::new(7);
    let mut mechanism = M::new();
    let start = place(&mechanism);
    for round in 0..cases(4_000) {
        if round % 5 == 4 {
            let motors = mechanism.motors();
            let motors = motors.as_ref().iter();
            let motors: Vec<f64> = motors.map(|motor| motor + dice.between(-stir, stir)).collect();
            mechanism.set(&motors);
        }
        let here = place(&mechanism);
        let from = if dice.once_in(3) { start } else { here };
        let mut goal = from;
        for (number, far) in goal.iter_mut().zip(far) {
            *number += dice.between(-far, far);
        }
        let before = mechanism;
        match mechanism.lead(&goal[..count]) {
            Ok(()) => {
                arrived += 1;
                let there = place(&mechanism);
                let turned = (there[2] - goal[2]) / TAU;
                let turned = if count == 3 { TAU * (turned - turned.round()) } else { 0.0 };
                let away = (there[0] - goal[0]).hypot(there[1] - goal[1]).max(turned.abs());
                let sine = sine(&mechanism).abs();
                // It is where these values of its motors have it.
                let mut again = mechanism;
                assert!(again.set(mechanism.motors().as_ref()), "{}", M::NAME);
                let pairs = again.poses().iter().zip(mechanism.poses());
                let moved = pairs.fold(0.0, |moved: f64, (to, from)| {
                    let turned = (to.cos - from.cos).hypot(to.sin - from.sin);
                    moved.max(turned).max((to.x - from.x).hypot(to.y - from.y))
                });
                // These are told as sums, with all whole turns.
                let values = mechanism.motors();
                let turned = values.as_ref().iter().fold(1.0, |most: f64, now| most.max(now.abs()));
                worst = worst.max(sine * away.max(misfit(&mechanism)).max(moved / turned));
            }
            Err(blocked) => {
                refused += 1;
                assert_eq!(mechanism, before, "{}: {blocked}", M::NAME);
                assert!(!is_free(&here, &goal), "{} from {here:?} to {goal:?}: {blocked}", M::NAME);
                // It says how far the point goes, on the way.
                let ends = here.iter().zip(&goal).zip(&blocked.reached);
                let outside =
                    ends.map(|((from, to), at)| (at - from.max(*to)).max(from.min(*to) - at));
                let outside = outside.take(2).fold(0.0, f64::max);
                assert!(outside < 1e-9, "{} from {here:?} to {goal:?}: {blocked}", M::NAME);
            }
        }
    }
    println!("{}: {arrived} places reached, {refused} refused, worst {worst:.1e}", M::NAME);
    assert!(worst < 1e-13, "{}: {worst:e}", M::NAME);
    assert!(arrived > 20 * refused.min(1) && arrived > refused, "{}", M::NAME);
}

/// Whether the way from one place to another stays between these distances from a point, and away from both.
fn stays_within(centre: [f64; 2], [near, wide]: [f64; 2], from: &[f64; 3], to: &[f64; 3]) -> bool {
    (0..=200).all(|step| {
        let part = f64::from(step) / 200.0;
        let at = [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part - centre[axis]);
        let distance = at[0].hypot(at[1]);
        near + 0.02 < distance && distance < wide - 0.02
    })
}

#[test]
fn a_plotter_comes_wherever_both_of_its_arms_do() {
    let is_free = |from: &[f64; 3], to: &[f64; 3]| {
        let feet = [[-1.0, 0.0], [1.0, 0.0]];
        feet.iter().all(|foot| stays_within(*foot, [0.5, 4.5], from, to))
    };
    let sine = |plotter: &Plotter| {
        let [_, _, pen, rod] = *plotter.poses();
        pen.cos * rod.sin - pen.sin * rod.cos
    };
    lead::<Plotter>([2.0, 1.5, 0.0], 0.3, is_free, sine);
    // So little that links take the poses that were found for the place.
    lead::<Plotter>([0.1, 0.1, 0.0], 0.03, is_free, sine);
}

#[test]
fn an_arm_by_a_belt_keeps_count_of_turns() {
    let fore = 2_f64.sqrt();
    let is_free = |from: &[f64; 3], to: &[f64; 3]| {
        stays_within([0.0, 0.0], [2.0 - fore, 2.0 + fore], from, to)
    };
    let closed_form = |arm: &Scara| {
        let [drive, shoulder] = arm.motors();
        // The coordinate of the drive is that of the ground against the pulley.
        let forearm = shoulder + (-drive - shoulder) * 20.0 / 30.0;
        let tip = [
            2.0 * shoulder.cos() + fore * (forearm + PI / 4.0).cos(),
            2.0 * shoulder.sin() + fore * (forearm + PI / 4.0).sin(),
        ];
        let [x, y, _] = place(arm);
        let away = (tip[0] - x).hypot(tip[1] - y);
        // A value of many radians is rounded to so much less.
        let turned = 10.0 + drive.abs().max(shoulder.abs());
        assert!(away < 1e-15 * turned, "{:?}: {away:e}", arm.motors());
        1.0
    };
    lead::<Scara>([1.5, 1.5, 0.0], 4.0, is_free, closed_form);
}

#[test]
fn a_bucket_is_led_with_its_angle() {
    let sine = |excavator: &Excavator| {
        let at = |name: &str| {
            let joint = Excavator::JOINTS.iter().find(|joint| joint.name == name);
            let [anchor, _] = joint.and_then(|joint| joint.anchors).expect("it is a pin");
            let pose = Pose::of_link(anchor.link.expect("all poses are known"), excavator.poses());
            pose.expect("it has a pose").apply(anchor.at)
        };
        let cylinders = [["a", "f1", "h1"], ["b", "f2", "h2"], ["c", "f3", "h3"]];
        let sines = cylinders.map(|names| {
            let [pivot, foot, head] = names.map(at);
            let [lever, cylinder] = [pivot, foot].map(|end| [head[0] - end[0], head[1] - end[1]]);
            let lengths = [lever, cylinder].map(|[x, y]| x.hypot(y));
            (lever[0] * cylinder[1] - lever[1] * cylinder[0]).abs() / (lengths[0] * lengths[1])
        });
        sines.into_iter().fold(1.0, f64::min)
    };
    lead::<Excavator>([0.3, 0.3, 0.2], 0.1, |_, _| false, sine);
}

#[test]
fn a_pantograph_does_what_its_ends_do() {
    // Its bars are as long as the root of 3.25, rounded: that moves its elbow by so much, divided by the sine there.
    let closed_form = |pantograph: &Pantograph| {
        let [y, x] = pantograph.motors();
        let [px, py, _] = place(pantograph);
        let [_, _, a, b, ..] = *pantograph.poses();
        let ([u, v], [w, z]) = (a.turn([1.0, 1.5]), b.turn([1.0, -1.5]));
        let sine = (u * z - v * w) / 3.25;
        let away = (4.0 - x - px).abs().max((2.0 * y - py).abs());
        assert!(away * sine.abs() < 1e-14, "{:?}: {away:e}", pantograph.motors());
        sine
    };
    lead::<Pantograph>([0.6, 0.8, 0.0], 0.2, |_, _| false, closed_form);
}

/// The feet, knees and hips of the platform's legs.
const LEGS: [[[f64; 2]; 3]; 3] = [
    [[0.0, 0.0], [0.4, 1.6], [2.2, 1.2]],
    [[6.0, 0.0], [4.4, -0.4], [3.8, 1.2]],
    [[3.0, 5.0], [4.6, 4.2], [3.0, 2.6]],
];

fn length([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    (ax - bx).hypot(ay - by)
}

/// By what the platform is determined while its motors rest: by the lines of its shins, of which each is given by its direction, and by an
/// arm from the middle of the platform. It is zero where all of them meet, or are parallel: there it moves although its motors rest.
fn held_by(shins: [([f64; 2], [f64; 2]); 3]) -> f64 {
    let line = |([x, y], [u, v]): ([f64; 2], [f64; 2])| [x, y, u * y - v * x];
    let [a, b, c] = shins.map(line);
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// Whether the values of the motors tell a place of the platform, whatever way its knees point.
fn is_told_by_motors(place: &[f64; 3]) -> bool {
    let [x, y, angle] = *place;
    let (sin, cos) = angle.sin_cos();
    let shin = |leg: usize, way: f64| {
        let [foot, knee, hip] = LEGS[leg];
        let [a, b] = [hip[0] - 3.0, hip[1] - 1.6];
        let arm = [cos * a - sin * b, sin * a + cos * b];
        let [u, v] = [x + arm[0] - foot[0], y + arm[1] - foot[1]];
        let (thigh, shin, far) = (length(foot, knee), length(knee, hip), u.hypot(v));
        let bend = (thigh * thigh + far * far - shin * shin) / (2.0 * thigh * far);
        let lean = v.atan2(u) + way * bend.clamp(-1.0, 1.0).acos();
        ([(u - thigh * lean.cos()) / shin, (v - thigh * lean.sin()) / shin], arm)
    };
    (0..8).all(|knees: u32| {
        let way = |leg: usize| if knees >> leg & 1 == 0 { 1.0 } else { -1.0 };
        held_by([0, 1, 2].map(|leg| shin(leg, way(leg)))).abs() > 1e-5
    })
}

#[test]
fn a_platform_on_three_legs_is_led_in_closed_form() {
    let is_free = |from: &[f64; 3], to: &[f64; 3]| {
        is_told_by_motors(to)
            && (0..=200).all(|step| {
                let part = f64::from(step) / 200.0;
                let [x, y, angle] =
                    [0, 1, 2].map(|axis| from[axis] + (to[axis] - from[axis]) * part);
                LEGS.iter().all(|[foot, knee, hip]| {
                    let (sin, cos) = angle.sin_cos();
                    let [a, b] = [hip[0] - 3.0, hip[1] - 1.6];
                    let hip_now =
                        [x + cos * a - sin * b - foot[0], y + sin * a + cos * b - foot[1]];
                    let [upper, lower] = [length(*foot, *knee), length(*knee, *hip)];
                    let distance = hip_now[0].hypot(hip_now[1]);
                    (upper - lower).abs() + 0.02 < distance && distance < upper + lower - 0.02
                })
            })
    };
    let held = |platform: &Platform| {
        let poses = platform.poses();
        let [body, _, first, _, second, _, third] = *poses;
        let shins = [first, second, third].into_iter().zip(LEGS).map(|(pose, [_, knee, hip])| {
            let long = length(knee, hip);
            let along = pose.turn([0, 1].map(|axis| (hip[axis] - knee[axis]) / long));
            (along, body.turn([hip[0] - 3.0, hip[1] - 1.6]))
        });
        let shins: Vec<_> = shins.collect();
        // Its loops wait for each other: an iteration leaves them be where they close to four ulps of all their sides together.
        0.25 * held_by([shins[0], shins[1], shins[2]]).abs().min(1.0)
    };
    lead::<Platform>([0.5, 0.5, 0.4], 0.02, is_free, held);
}

#[test]
fn what_cannot_be_reached_is_refused_and_nothing_moves() {
    let mut plotter = Plotter::new();
    let start = plotter;
    let blocked = plotter.reach([6.0, 0.0]).expect_err("it is too far away");
    assert_eq!(blocked.cause, Cause::Open);
    let [x, y] = blocked.reached;
    assert!((x + 1.0).hypot(y) < 4.5 + 1e-9 && x > 2.0, "{blocked}");
    assert_eq!(plotter, start);
    let wrong = plotter.reach([0.0, f64::INFINITY]).expect_err("it is no place");
    assert_eq!((wrong.cause, wrong.place), (Cause::NotFinite, "y"));
    assert_eq!(plotter, start);
    assert_eq!(plotter.reach([0.3, 2.9]), Ok(()));
}

#[test]
fn motors_keep_their_turns_when_they_follow() {
    let mut arm = Scara::new();
    assert!(arm.move_to([40.0, -30.0]).is_ok());
    let [drive, shoulder] = arm.motors();
    let [x, y, _] = place(&arm);
    assert_eq!(arm.reach([x + 1e-3, y - 1e-3]), Ok(()));
    let [after, also] = arm.motors();
    assert!((after - drive).abs().max((also - shoulder).abs()) < 0.1);
}

#[test]
fn what_a_mechanism_has_besides_goes_with_it() {
    let mut arm = Varied::new();
    let [upper, hand, elbow] = [0, 1, 2];
    assert_eq!(arm.set_length(1.2), Ok(()));
    assert_eq!(arm.move_with([0.1, 0.2, 1.0], [1.0, 1.0, 1.0]), Ok(()));
    let seen = arm.fore_wrist_trace().len();
    assert_eq!(arm.reach([1.0, 2.2]), Ok(()));
    let motors = arm.motors();
    assert!((motors[hand] - 0.2).abs() < 1e-6);
    let (a, b) = (motors[upper], motors[upper] + motors[elbow]);
    let wrist = [2.0 * a.cos() + 1.2 * b.cos(), 2.0 * a.sin() + 1.2 * b.sin()];
    assert!((wrist[0] - 1.0).abs().max((wrist[1] - 2.2).abs()) < 1e-6, "{motors:?}");
    assert!(arm.velocities().iter().all(|velocity| velocity.angular == 0.0));
    assert_eq!(arm.fore_wrist_trace().len(), seen + 1);
}

#[test]
fn a_motor_does_not_leave_its_range() {
    let mut arm = Limited::new();
    let before = arm;
    // Folded up, the elbow would leave its range before the loop is open.
    let blocked = arm.reach([1.5, 0.0]).expect_err("the elbow is at its limit");
    assert_eq!((blocked.cause, blocked.place, arm), (Cause::OutOfRange, "elbow", before));
    let [x, y] = blocked.reached;
    // By the law of cosines, from where its forearm is at 45 and 60 degrees more.
    let fore = 2_f64.sqrt();
    let least = (4.0 + fore * fore + 4.0 * fore * (105.0 * PI / 180.0).cos()).sqrt();
    assert!(x.hypot(y) > least && x.hypot(y) < least + 1e-3, "{blocked}");
    assert_eq!(arm.reach([x, y]), Ok(()));
}

#[test]
fn a_point_comes_everywhere_in_its_region_and_nowhere_else() {
    let mut dice = Dice::new(3);
    let mut plotter = Paper::new();
    for _ in 0..cases(4_000) {
        let place = [dice.between(-1.5, 1.5), dice.between(2.5, 4.2)];
        assert_eq!(plotter.reach(place), Ok(()), "{place:?}");
        let tip = plotter.pen_tip();
        assert!((tip.x - place[0]).hypot(tip.y - place[1]) < 1e-13);
    }
    let before = plotter;
    let blocked = plotter.reach([0.0, 4.3]).expect_err("that is beside the paper");
    assert_eq!((blocked.cause, blocked.place), (Cause::OutOfRange, "y"));
    assert_eq!(plotter, before);
    assert!(blocked.reached[1] <= 4.2, "{blocked}");
}

#[test]
fn rates_of_motors_are_those_of_their_differences() {
    const STEP: f64 = 1e-4;
    let way = |t: f64| [0.4 + 0.3 * t - 0.5 * t * t, 3.0 - 0.7 * t + 0.2 * t * t];
    let motors = [-STEP, 0.0, STEP].map(|t| {
        let mut plotter = Paper::new();
        assert_eq!(plotter.reach(way(t)), Ok(()));
        plotter.motors()
    });
    let mut plotter = Paper::new();
    assert_eq!(plotter.reach_with(way(0.0), [0.3, -0.7], [-1.0, 0.4]), Ok(()));
    let tip = (plotter.pen_tip_velocity(), plotter.pen_tip_acceleration());
    assert!((tip.0.x - 0.3).hypot(tip.0.y + 0.7) < 1e-13);
    assert!((tip.1.x + 1.0).hypot(tip.1.y - 0.4) < 1e-12);
    let rates = [plotter.l_rate(), plotter.r_rate()];
    let accelerations = [plotter.l_acceleration(), plotter.r_acceleration()];
    for motor in 0..2 {
        let [before, here, after] = motors.map(|motors| motors[motor]);
        let rate = (after - before) / (2.0 * STEP);
        let acceleration = (after - 2.0 * here + before) / (STEP * STEP);
        assert!((rate - rates[motor]).abs() < 1e-6, "{rate} and {}", rates[motor]);
        let off = (acceleration - accelerations[motor]).abs();
        assert!(off < 1e-5, "{acceleration} and {}", accelerations[motor]);
    }
    let before = plotter;
    let wrong = plotter.reach_with([0.0, 3.0], [0.0, f64::NAN], [0.0; 2]);
    let wrong = wrong.expect_err("it is no velocity");
    assert_eq!((wrong.cause, wrong.place), (Cause::NotFinite, "y"));
    assert_eq!(plotter, before);
}

#[test]
fn the_angle_of_a_led_link_has_a_rate() {
    const STEP: f64 = 1e-5;
    let way = |t: f64| [3.1 + 0.2 * t, 1.5 - 0.1 * t, 0.05 + 0.4 * t];
    let motors = [-STEP, STEP].map(|t| {
        let mut platform = Platform::new();
        assert_eq!(platform.reach(way(t)), Ok(()));
        platform.motors()
    });
    let mut platform = Platform::new();
    assert_eq!(platform.reach_with(way(0.0), [0.2, -0.1, 0.4]), Ok(()));
    assert!((platform.platform_velocity().angular - 0.4).abs() < 1e-13);
    let rates = [platform.m1_rate(), platform.m2_rate(), platform.m3_rate()];
    for motor in 0..3 {
        let rate = (motors[1][motor] - motors[0][motor]) / (2.0 * STEP);
        assert!((rate - rates[motor]).abs() < 1e-7, "{rate} and {}", rates[motor]);
    }
}

#[test]
fn a_point_is_where_its_path_has_it() {
    const STEP: f64 = 1e-4;
    let path = |t: f64| [t.cos(), 3.3 + 0.6 * (2.0 * t).sin()];
    let mut compass = Compass::new();
    let mut dice = Dice::new(5);
    for _ in 0..cases(400) {
        let t = dice.between(-20.0, 20.0);
        let motors = [t - STEP, t + STEP, t].map(|t| {
            assert_eq!(compass.at_time(t), Ok(()), "{t}");
            compass.motors()
        });
        let (tip, [x, y]) = (compass.pen_tip(), path(t));
        assert!((tip.x - x).hypot(tip.y - y) < 1e-13, "{t}");
        let (velocity, acceleration) = (compass.pen_tip_velocity(), compass.pen_tip_acceleration());
        let off = (velocity.x + t.sin()).hypot(velocity.y - 1.2 * (2.0 * t).cos());
        assert!(off < 1e-12, "{t}: {off:e}");
        let off = (acceleration.x + t.cos()).hypot(acceleration.y + 2.4 * (2.0 * t).sin());
        assert!(off < 1e-11, "{t}: {off:e}");
        let [before, after, here] = motors;
        let rates = [compass.l_rate(), compass.r_rate()];
        let accelerations = [compass.l_acceleration(), compass.r_acceleration()];
        for motor in 0..2 {
            let rate = (after[motor] - before[motor]) / (2.0 * STEP);
            let second = (after[motor] - 2.0 * here[motor] + before[motor]) / (STEP * STEP);
            assert!((rate - rates[motor]).abs() < 1e-5, "{t}: {rate}");
            assert!((second - accelerations[motor]).abs() < 1e-4, "{t}: {second}");
        }
    }
    assert_eq!(compass.set_size(0.5), Ok(()));
    assert_eq!(compass.at_time(0.7), Ok(()));
    let (tip, [x, y]) = (compass.pen_tip(), path(0.7));
    assert!((tip.x - 0.5 * x).hypot(tip.y - y) < 1e-13);
    let before = compass;
    let wrong = compass.at_time(f64::NAN).expect_err("it is no time");
    assert_eq!((wrong.cause, compass), (Cause::NotFinite, before));
}

#[test]
fn a_link_has_the_place_and_angle_of_its_path() {
    let mut rocking = Rocking::new();
    for step in 0..=400 {
        let t = 0.05 * f64::from(step);
        assert_eq!(rocking.at_time(t), Ok(()), "{t}");
        let pose = rocking.platform().rotation.angle();
        let middle = rocking.platform_middle();
        let off = (middle.x - 3.0 - 0.2 * t.cos()).hypot(middle.y - 1.6 - 0.2 * t.sin());
        assert!(off < 1e-13 && (pose - 0.15 * (3.0 * t).sin()).abs() < 1e-13, "{t}");
    }
}
