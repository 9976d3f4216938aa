//! `reach` beside a `move_to` to the same places; one process, interleaved rounds, medians, and the range of several repetitions.
//! `cargo bench -p mech-tests --bench inverse`

mod common;

use common::{Threshold, compare};
use mech_runtime::mechanism;
use std::f64::consts::TAU;
use std::hint::black_box;

mechanism! {
    struct Arm;
    link upper;
    link forearm { point hand = (3, 1); }
    joint shoulder = revolute(ground, upper) at (0, 0);
    joint elbow = revolute(upper, forearm) at (2, 0);
    motor shoulder;
    motor elbow;
    follow forearm.hand by shoulder, elbow;
}

macro_rules! plotter {
    ($name:ident, $($region:tt)*) => {
        mechanism! {
            struct $name;
            link left; link right; link rod;
            link pen { point tip = (0, 4); }
            joint l = revolute(ground, left) at (-1, 0);
            joint r = revolute(ground, right) at (1, 0);
            joint lk = revolute(left, pen) at (-2.4, 1.8);
            joint rk = revolute(right, rod) at (2.4, 1.8);
            joint tip = revolute(pen, rod) at (0, 4);
            motor l;
            motor r;
            follow pen.tip $($region)* by l, r;
        }
    };
}

plotter!(Plotter,);
plotter!(Proved, in (-1.5 ..= 1.5, 2.5 ..= 4.2));

macro_rules! race {
    ($what:literal, $name:ident, $centre:expr) => {
        let places: Vec<[f64; 2]> = (0..360)
            .map(|degree| {
                let (sin, cos) = (f64::from(degree) * TAU / 360.0).sin_cos();
                [$centre[0] + 0.6 * cos, $centre[1] + 0.4 * sin]
            })
            .collect();
        let mut led = $name::new();
        let motors = places.iter().map(|place| {
            assert_eq!(led.reach(*place), Ok(()));
            led.motors()
        });
        let motors: Vec<[f64; 2]> = motors.collect();
        let mut moved = led;
        compare(
            $what,
            ["reach", "move_to"],
            360.0,
            Threshold::AtMost(1.5),
            || {
                for place in black_box(&places) {
                    assert!(black_box(&mut led).reach(*place).is_ok());
                }
            },
            || {
                for motors in black_box(&motors) {
                    assert!(black_box(&mut moved).move_to(*motors).is_ok());
                }
            },
        );
    };
}

fn main() {
    race!("an arm", Arm, [1.5, 2.0]);
    race!("a plotter", Plotter, [0.0, 3.4]);
    race!("a plotter, region proved", Proved, [0.0, 3.4]);
}
