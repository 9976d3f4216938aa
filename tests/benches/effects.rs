//! What velocities, accelerations and static torques cost beside positions alone: the same exact four-bar, one process, interleaved rounds,
//! medians. `cargo bench -p mech-tests --bench effects`
#![allow(clippy::cast_precision_loss, reason = "small numbers")]

mod common;

use common::{Threshold, compare};
use mech_test_support::four_bar;
use std::hint::black_box;

four_bar!(struct Position: f64; motor a;);
four_bar!(struct Fast: f64; motor a; effects { velocity; });
four_bar!(struct Faster: f64; motor a; effects { velocity; acceleration; });
four_bar!(struct Held: f64; motor a; load push = force(coupler.tip); gravity (0, -9.81); effects { force; });

/// How much of the last position goes into the next angle in a dependent sequence: too little to be seen.
const PART: f64 = 1e-18;

fn main() {
    let angles: [f64; 360] = std::array::from_fn(|degree| (degree as f64).to_radians());
    for dependent in [true, false] {
        let how = if dependent { "each after the last" } else { "independent" };
        let mut position = Position::new();
        let mut alone = || {
            for angle in black_box(&angles) {
                let mechanism = black_box(&mut position);
                let last = if dependent { mechanism.poses()[2].sin } else { 0.0 };
                let angle = angle + PART * last;
                assert!(mechanism.move_to([angle]).is_ok());
            }
        };
        let mut fast = Fast::new();
        compare(
            &format!("velocity to position alone, {how}"),
            ["velocity", "position"],
            360.0,
            Threshold::AtMost(1.7),
            || {
                for angle in black_box(&angles) {
                    let mechanism = black_box(&mut fast);
                    let last = if dependent { mechanism.poses()[2].sin } else { 0.0 };
                    let angle = angle + PART * last;
                    assert!(mechanism.move_with([angle], [1.5]).is_ok());
                }
            },
            &mut alone,
        );
        let mut faster = Faster::new();
        compare(
            &format!("velocity and acceleration to position alone, {how}"),
            ["acceleration", "position"],
            360.0,
            Threshold::AtMost(2.7),
            || {
                for angle in black_box(&angles) {
                    let mechanism = black_box(&mut faster);
                    let last = if dependent { mechanism.poses()[2].sin } else { 0.0 };
                    let angle = angle + PART * last;
                    assert!(mechanism.move_with([angle], [1.5], [0.7]).is_ok());
                }
            },
            &mut alone,
        );
        let mut held = Held::new();
        assert!(held.set_push([3.0, -2.0]).is_ok());
        compare(
            &format!("static torque to position alone, {how}"),
            ["torque", "position"],
            360.0,
            Threshold::AtMost(2.4),
            || {
                for angle in black_box(&angles) {
                    let mechanism = black_box(&mut held);
                    let last = if dependent { mechanism.poses()[2].sin } else { 0.0 };
                    let angle = angle + PART * last;
                    assert!(black_box(mechanism.hold_at([angle])).is_ok());
                }
            },
            &mut alone,
        );
    }
}
