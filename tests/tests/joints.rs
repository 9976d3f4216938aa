//! What mechanisms tell of their joints, beside where the poses of their links put these.

use super::zoo;
use mech_runtime::{Coordinate, JointInfo, JointKind, Mechanism};
use mech_test_support::{cross, dot};
use std::f64::consts::{PI, TAU};

include!(concat!(env!("OUT_DIR"), "/joints.rs"));

type Vector = [f64; 2];

#[track_caller]
fn near(found: f64, expected: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(off < 1e-9 * (1.0 + expected.abs()), "{what}: {found}, not {expected}");
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
    planetary: zoo::Planetary;
    differential: zoo::Differential;
    two_racks: zoo::TwoRacks;
    rolling_wheel: zoo::Rolling;
    slotted_arm: zoo::SlottedArm;
    welded: zoo::Welded;
    presses: Presses;
    double_butterfly: zoo::DoubleButterfly;
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
    assert!(anchors.iter().all(|anchor| anchor.place(press.poses()).is_none()));
    assert!(
        bed.anchors.expect("a line").iter().all(|anchor| anchor.place(press.poses()).is_some())
    );
}

#[test]
fn anchors_are_as_at_the_start_whatever_params_become() {
    let mut press = Press::new();
    press.set_throw(0.5).expect("it closes");
    let anchors = Press::JOINTS[1].anchors.expect("it has a place");
    assert_eq!(anchors.map(|anchor| anchor.at), [[1.0, 0.0], [0.0, 0.0]]);
}
