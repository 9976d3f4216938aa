//! One four-bar by the generated code and by other crates: nanoseconds a position, and the error against exact geometry.

#[path = "../../benches/common/mod.rs"]
mod common;
mod physics;

use common::{Threshold, compare};
use four_bar::mech::fb::{FourBar, NormFourBar, UnNorm};
use four_bar::mech::{CurveGen, Stat};
use mech_runtime::mechanism;
use physics::{Joints, World};
use std::hint::black_box;

mechanism! {
    struct Emitted;

    ground { point crank_shaft = (0, 0); point rocker_shaft = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler { point a = (0, 0); point b = (3.5, 0); }
    link rocker { point shaft = (0, 0); point b = (3, 0); }

    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.a);
    joint c = revolute(coupler.b, rocker.b);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);

    motor a;
    start { coupler near 50 deg; }
}

const GROUND: f64 = 4.0;
const COUPLER: f64 = 3.5;
const ROCKER: f64 = 3.0;
/// Degrees a step; at 60 steps a second a turn takes six seconds.
const STEP: f64 = 1.0;

/// Where the coupler is pinned to the rocker at this angle of the crank, by angles: other formulas than all that is timed.
fn exact(crank: f64) -> [f64; 2] {
    let (sin, cos) = crank.sin_cos();
    let diagonal = (GROUND - cos).hypot(sin);
    let cosine =
        (COUPLER * COUPLER + diagonal * diagonal - ROCKER * ROCKER) / (2.0 * COUPLER * diagonal);
    let direction = (-sin).atan2(GROUND - cos) + cosine.acos();
    [cos + COUPLER * direction.cos(), sin + COUPLER * direction.sin()]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn angles() -> Vec<f64> {
    (1..=360).map(|step| (f64::from(step) * STEP).to_radians()).collect()
}

fn peer() -> FourBar {
    let norm =
        NormFourBar { l1: GROUND, l3: COUPLER, l4: ROCKER, l5: 0.0, g: 0.0, stat: Stat::C1B1 };
    FourBar::new(UnNorm::from_driver(1.0), norm)
}

/// The worst error of the generated code and of the crate `four-bar` over a turn.
fn errors() -> [f64; 2] {
    let (mut emitted, peer) = (Emitted::new(), peer());
    let mut worst = [0.0_f64; 2];
    for angle in angles() {
        emitted.move_to([angle]).expect("the crank turns");
        let end = emitted.coupler_b();
        let [_, _, _, peer, _] = peer.pos(angle).expect("the crank turns");
        worst[0] = worst[0].max(distance([end.x, end.y], exact(angle)));
        worst[1] = worst[1].max(distance(peer, exact(angle)));
    }
    worst
}

fn main() {
    let [ours, theirs] = errors();
    println!(
        "error of the pin between coupler and rocker, lengths 1 to 4, in {STEP}° steps: emitted {ours:.1e}, four-bar {theirs:.1e}"
    );
    let (angles, mut emitted, peer) = (angles(), Emitted::new(), peer());
    compare(
        "four-bar, pos()",
        ["four-bar", "emitted"],
        360.0,
        Threshold::AtLeast(4.0),
        || {
            for angle in black_box(&angles) {
                assert!(black_box(black_box(&peer).pos(*angle)).is_some());
            }
        },
        || {
            for angle in black_box(&angles) {
                assert!(black_box(&mut emitted).move_to([*angle]).is_ok());
            }
        },
    );
    for joints in [Joints::Impulse, Joints::Multibody] {
        let mut world = World::new(joints, STEP);
        // One turn to get going, one to look at.
        for _ in 0..360 {
            world.step();
        }
        let (mut worst, mut lag) = (0.0_f64, 0.0_f64);
        for step in 361..=720 {
            world.step();
            worst = worst.max(distance(world.end(), exact(world.crank())));
            lag = lag.max(distance(world.end(), exact((f64::from(step) * STEP).to_radians())));
        }
        println!(
            "rapier2d, {joints:?}: error {worst:.1e} at the angle its crank has, {lag:.1e} at the angle it should have; its motor is off by {:.1e} rad",
            world.off()
        );
        // Few positions a call: it takes long.
        let some = &angles[..6];
        compare(
            &format!("rapier2d, {joints:?}"),
            ["rapier2d", "emitted"],
            6.0,
            Threshold::AtLeast(100.0),
            || (0..6).for_each(|_| black_box(&mut world).step()),
            || {
                for angle in black_box(some) {
                    assert!(black_box(&mut emitted).move_to([*angle]).is_ok());
                }
            },
        );
    }
}
