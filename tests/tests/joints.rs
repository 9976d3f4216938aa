//! What mechanisms tell of their joints, beside where the poses of their links put these.

use super::zoo;
use mech_runtime::{Coordinate, JointInfo, JointKind, Mechanism, mechanism};
use std::f64::consts::{PI, TAU};

type Vector = [f64; 2];

fn dot([a, b]: Vector, [c, d]: Vector) -> f64 {
    a * c + b * d
}

fn cross([a, b]: Vector, [c, d]: Vector) -> f64 {
    a * d - b * c
}

#[track_caller]
fn near(found: f64, expected: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(
        off < 1e-9 * (1.0 + expected.abs()),
        "{what}: {found}, not {expected}"
    );
}

/// The places and the directions in the scene of both parts of a joint, if it has a place.
fn parts<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    joint: &JointInfo<f64>,
) -> Option<([Vector; 2], [Vector; 2])> {
    let anchors = joint.anchors?;
    let poses = mechanism.poses();
    let places = anchors.map(|anchor| anchor.place(poses).expect("all links are shown"));
    let directions = anchors.map(|anchor| anchor.direction(poses).expect("all links are shown"));
    Some((places, directions))
}

/// Holds every joint to its definition, where the mechanism is.
fn check<M: Mechanism<Scalar = f64>>(mechanism: &M) {
    let (joints, motors) = (mechanism.joints(), mechanism.motors());
    assert_eq!(joints.as_ref().len(), M::JOINTS.len());
    for (joint, &value) in M::JOINTS.iter().zip(joints.as_ref()) {
        let what = format!("{}.{}", M::NAME, joint.name);
        assert_eq!(value.is_some(), joint.coordinate.is_some(), "{what}");
        if let Some(motor) = joint.motor {
            assert_eq!(M::MOTORS[motor], joint.name);
            assert_eq!(value, Some(motors.as_ref()[motor]), "{what}");
        }
        if joint.coordinate == Some(Coordinate::Angle) {
            assert!(value.is_some_and(|value| value.abs() <= PI), "{what}");
        }
        for (anchor, link) in joint.anchors.iter().flatten().zip(joint.links) {
            match anchor.link.expect("all links are shown") {
                0 => assert_eq!(link, "ground"),
                moving => assert_eq!(M::LINKS[moving - 1], link),
            }
        }
        let Some(([a, b], [from, to])) = parts(mechanism, joint) else {
            assert!(!matches!(
                joint.kind,
                JointKind::Revolute | JointKind::Prismatic | JointKind::Slot | JointKind::Weld
            ));
            assert_eq!(value, None, "{what}");
            continue;
        };
        let offset = [b[0] - a[0], b[1] - a[1]];
        let slides = matches!(joint.kind, JointKind::Prismatic | JointKind::Slot);
        if slides {
            near(cross(from, offset), 0.0, &what);
            near(value.expect("it slides"), dot(from, offset), &what);
        } else {
            near(offset[0].hypot(offset[1]), 0.0, &what);
        }
        if matches!(joint.kind, JointKind::Prismatic | JointKind::Weld) {
            near(cross(from, to), 0.0, &what);
            near(dot(from, to), 1.0, &what);
        }
        if joint.kind == JointKind::Revolute {
            let off = value.expect("it turns") - cross(from, to).atan2(dot(from, to));
            near(off - TAU * (off / TAU).round(), 0.0, &what);
        }
    }
}

/// Moves all motors, each at its own rate, as far as they go; angles that count turns never jump.
fn check_in_motion<M: Mechanism<Scalar = f64>>() {
    let mut mechanism = M::new();
    check(&mechanism);
    let mut last = mechanism.joints();
    for _ in 0..400 {
        let mut motors = mechanism.motors();
        for (motor, rate) in motors.as_mut().iter_mut().zip([0.05, -0.02, 0.03]) {
            *motor += rate;
        }
        // Wherever it comes to, it is somewhere.
        let _ = mechanism.move_toward(motors).expect("finite");
        check(&mechanism);
        let now = mechanism.joints();
        let values = last.as_ref().iter().zip(now.as_ref());
        for (joint, (before, after)) in M::JOINTS.iter().zip(values) {
            if let (Some(Coordinate::Turns), Some(before), Some(after)) =
                (joint.coordinate, before, after)
            {
                assert!((after - before).abs() < 3.0, "{}.{}", M::NAME, joint.name);
            }
        }
        last = now;
    }
}

mechanism! {
    /// So many joints that they stand in a table, and not all of them in its rows.
    struct Presses;
    part Press(unit = 1) {
        port frame { point shaft = (0, 0); line guide = (0, 0.5 * unit) -> (1, 0); }
        port crank { point pin = (unit, 0); }
        link rod { point pin = (0, 0); point end = (4 * unit, 0); }
        link ram { point end = (0, 0); line way = (0, 0) -> (1, 0); point tool = (unit, 0); }
        link tool { point tool = (0, 0) turned 10 deg; }
        joint big = revolute(crank.pin, rod.pin);
        joint small = revolute(rod.end, ram.end);
        joint slide = prismatic(frame.guide, ram.way);
        joint fixed = weld(ram.tool, tool.tool);
        start { rod near 10 deg; }
    }
    ground { point shaft = (0, 0); }
    link axle { point shaft = (0, 0); }
    joint main = revolute(ground.shaft, axle.shaft);
    motor main;
    use press[20]: Press(unit = 1 + 0.1 * k) { frame = ground, crank = axle };
}

macro_rules! cases {
    ($($test:ident: $mechanism:ty;)*) => {
        $(
            #[test]
            fn $test() {
                check_in_motion::<$mechanism>();
            }
        )*
    };
}

cases! {
    geared_piston: mech_gallery::geared_piston::GearedPiston;
    crank_rocker: mech_gallery::four_bar::CrankRocker;
    jansen: mech_gallery::jansen::JansenLeg;
    rocker_arm: mech_gallery::rocker_arm::RockerArm;
    slanted_guide: zoo::SlantedGuide;
    quick_return: zoo::QuickReturn;
    scotch_yoke: zoo::ScotchYoke;
    gear_on_rocker: zoo::GearOnRocker;
    planetary: zoo::rolling::Planetary;
    differential: zoo::rolling::Differential;
    two_racks: zoo::rolling::TwoRacks;
    rolling_wheel: zoo::rolling::Rolling;
    slotted_arm: zoo::special::SlottedArm;
    welded: zoo::special::Welded;
    presses: Presses;
    double_butterfly: zoo::special::DoubleButterfly;
}

mechanism! {
    /// A crank in line with a ram, of which little is asked.
    struct Press;
    param throw = 1.0;
    ground { point shaft = (0, 0); line bed = (0, 0) -> (1, 0); }
    link crank { point shaft = (0, 0); point pin = (throw, 0); }
    link rod { point big = (0, 0); point small = (4, 0); }
    link ram { point pin = (0, 0); line axis = (0, 0) -> (1, 0); }
    joint turn = revolute(ground.shaft, crank.shaft);
    joint big = revolute(crank.pin, rod.big);
    joint small = revolute(rod.small, ram.pin);
    joint bed = prismatic(ground.bed, ram.axis);
    motor turn;
    start { turn = 60 deg; rod near -10 deg; }
    show ram, bed;
}

#[test]
fn what_is_not_shown_has_no_coordinate_and_no_pose() {
    let mut press = Press::new();
    press.move_to([7.5]).expect("it turns");
    assert_eq!(press.joints(), [None, None, None, Some(press.bed())]);
    let names = Press::JOINTS.map(|joint| joint.name);
    assert_eq!(names, ["turn", "big", "small", "bed"]);
    // The motor is told of, though its joint is not shown.
    let motors = Press::JOINTS.map(|joint| joint.motor);
    assert_eq!(motors, [Some(0), None, None, None]);
    let [_, big, _, bed] = Press::JOINTS;
    let anchors = big.anchors.expect("it has a place");
    assert!(
        anchors
            .iter()
            .all(|anchor| anchor.place(press.poses()).is_none())
    );
    assert!(
        bed.anchors
            .expect("a line")
            .iter()
            .all(|anchor| anchor.place(press.poses()).is_some())
    );
}

#[test]
fn anchors_are_as_at_the_start_whatever_params_become() {
    let mut press = Press::new();
    press.set_throw(0.5).expect("it closes");
    let anchors = Press::JOINTS[1].anchors.expect("it has a place");
    assert_eq!(anchors.map(|anchor| anchor.at), [[1.0, 0.0], [0.0, 0.0]]);
}
