//! What rolls keeps its exact ratio; what is coupled, redundant or slotted is where another method says.

use super::zoo::{self, rolling, special};
use mech_compiler::plan::{Mesh, Rational, Step};
use mech_runtime::{Mechanism, mechanism};
use mech_test_support::mechanism_of;
use std::f64::consts::TAU;

mechanism! {
    /// The six-bar of [`special::StephensonFar`], driven where it is sequential.
    struct StephensonNear;
    link crank;
    link coupler;
    link rocker;
    link rod;
    link driver;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.7, 1.2);
    joint c = revolute(coupler, rocker) at (3.6, 2.4);
    joint d = revolute(ground, rocker) at (4, 0);
    joint e = revolute(coupler, rod) at (2.2, 3.6);
    joint f = revolute(rod, driver) at (5.6, 4.6);
    joint g = revolute(ground, driver) at (6.4, 1.6);
    motor a;
}

/// What moves a joint of a mechanism that rolls, exactly.
fn moved<M: Mechanism>(joint: &str) -> Vec<Rational> {
    let (model, compiled) = mechanism_of::<M>(include_str!("zoo/rolling.rs"));
    let named = |mesh: &&Mesh| model.joint(mesh.connection.joint).name == joint;
    let meshes = compiled.plan.steps.iter().filter_map(|step| {
        if let Step::Mesh(mesh) = step {
            Some(mesh)
        } else {
            None
        }
    });
    let mesh = meshes
        .into_iter()
        .find(named)
        .expect("something rolls there");
    mesh.parts.iter().map(|(_, part)| part.clone()).collect()
}

fn rational(above: i64, below: i64) -> Rational {
    Rational::new(above.into(), below.into())
}

#[test]
fn the_planetary_is_exact() {
    assert_eq!(moved::<rolling::Planetary>("a"), [rational(5, 12)]);
    // The planet turns by itself: −5 (sun − arm) = −35/12 on the arm.
    assert_eq!(moved::<rolling::Planetary>("p"), [rational(-35, 12)]);
    let mut planetary = rolling::Planetary::new();
    for turns in [0.1, 1.0, 12.0, -7.3] {
        planetary.move_to([turns * TAU]).unwrap();
        let off = planetary.a() - turns * TAU * 5.0 / 12.0;
        assert!((off - TAU * (off / TAU).round()).abs() < 1e-13);
    }
}

#[test]
fn a_differential_adds_its_inputs() {
    assert_eq!(
        moved::<rolling::Differential>("a"),
        [rational(5, 12), rational(7, 12)]
    );
}

#[test]
fn a_clock_train_is_exact_and_does_not_drift() {
    let hand = rational(-8, 60) * rational(-10, 64) * rational(-12, 75);
    assert_eq!(moved::<rolling::Clock>("d"), std::slice::from_ref(&hand));
    assert_eq!(moved::<rolling::Clock>("e"), [hand * rational(2, 3)]);
    // Ten million turns forwards in leaps, and the same position as after none.
    let mut clock = rolling::Clock::new();
    for step in 1..=1_000 {
        clock.move_to([f64::from(step) * 1e4 * TAU]).unwrap();
    }
    let mut fresh = rolling::Clock::new();
    fresh.move_to([1e7 * TAU]).unwrap();
    assert_eq!(clock.poses(), fresh.poses());
    // 10⁷ turns times 1/300 · 2/3 of a turn: the exact angle, reduced in whole numbers.
    let turns = -(10_000_000.0_f64 * 2.0 / 900.0 % 1.0);
    let off = (clock.e() - turns * TAU) / TAU;
    assert!((off - off.round()).abs() < 1e-9, "{off:e}");
}

#[test]
fn racks_move_by_their_radius() {
    let mut racks = rolling::TwoRacks::new();
    let mut wheel = rolling::Rolling::new();
    for value in [0.3, -2.0, 10.0] {
        racks.move_to([value]).unwrap();
        assert!((racks.lower_mark().x - 1.0 - value).abs() < 1e-14);
        // The upper rack is on the other side of the pinion: it goes in the other direction.
        assert!((racks.upper_mark().x - 1.0 + value).abs() < 1e-13);
        assert!((racks.low() - value).abs() < 1e-14 && (racks.up() - value).abs() < 1e-13);
        wheel.move_to([value]).unwrap();
        // Rolling without slip: the wheel has turned back by displacement / radius.
        let off = wheel.wheel().rotation.angle() + value;
        assert!((off - TAU * (off / TAU).round()).abs() < 1e-13);
    }
}

#[test]
fn a_pin_in_a_slot_is_a_die_that_nobody_sees() {
    let (mut slotted, mut with_die) = (special::SlottedArm::new(), zoo::QuickReturn::new());
    for degree in 0..360 {
        let angle = f64::from(degree).to_radians();
        slotted.move_to([angle]).unwrap();
        with_die.move_to([angle]).unwrap();
        assert!((slotted.d() - with_die.d()).abs() < 1e-12);
        assert!((slotted.x() - with_die.x()).abs() < 1e-12);
    }
    assert_eq!(
        <special::SlottedArm as mech_runtime::Mechanism>::LINKS,
        ["crank", "arm"]
    );
}

#[test]
fn a_weld_keeps_two_links_one() {
    let mut welded = special::Welded::new();
    for degree in 0..360 {
        welded.move_to([f64::from(degree).to_radians()]).unwrap();
        let apart = welded.rocker().inverse() * welded.hand();
        assert!(apart.translation.vector.norm() < 1e-14 && apart.rotation.angle().abs() < 1e-15);
    }
}

#[test]
fn a_wedge_lifts_by_its_slope() {
    let mut wedge = special::Wedge::new();
    for value in [0.5, -1.0, 3.0] {
        wedge.move_to([value]).unwrap();
        assert!((wedge.y() + value / 2.0).abs() < 1e-14);
    }
}

#[test]
fn a_parallelogram_translates_its_rail() {
    let mut cranks = special::ThreeCranks::new();
    for degree in -30..=60 {
        let angle = f64::from(degree).to_radians();
        cranks.move_to([angle]).unwrap();
        let (sin, cos) = angle.sin_cos();
        // The pin of the first crank was at (0.5, 1); the rail keeps its direction.
        let tip = cranks.rail_tip();
        assert!((tip.x - (4.5 + 0.5 * cos - sin)).abs() < 1e-13);
        assert!((tip.y - (1.0 + 0.5 * sin + cos)).abs() < 1e-13);
        assert!((cranks.c() - angle).abs() < 1e-13 && (cranks.b() - angle).abs() < 1e-13);
    }
}

/// Driven at its crank the six-bar is two loops in sequence; driven at its far pivot it is one system of two rings. Both must
/// tell the same positions.
#[test]
fn stephenson_iii_from_its_far_side() {
    let (mut near, mut far) = (StephensonNear::new(), special::StephensonFar::new());
    near.move_to([1e-3]).unwrap();
    let forwards = near.g().signum();
    let (mut worst, mut followed) = (0.0_f64, 0);
    for step in 1..=400 {
        let last = near.g();
        near.move_to([forwards * 2e-3 * f64::from(step)]).unwrap();
        if near.g() < last + 1e-5 {
            // The driver comes near its own dead point: it cannot lead any more.
            break;
        }
        far.move_to([near.g()]).unwrap();
        followed += 1;
        let links = [
            (near.crank(), far.crank()),
            (near.coupler(), far.coupler()),
            (near.rod(), far.rod()),
        ];
        for (near, far) in links {
            worst = worst.max((near.rotation.angle() - far.rotation.angle()).abs());
            worst = worst.max((near.translation.vector - far.translation.vector).norm());
        }
    }
    println!("Stephenson III from its far side: {worst:.1e} over {followed} positions");
    assert!(followed > 100 && worst < 1e-12, "{worst:e} over {followed}");
}

/// The geared five-bar driven at a crank is a dyad; driven between its rods it is a ring of four unknown angles, two of them
/// tied. Both must tell the same positions, and the gear must keep its ratio.
#[test]
fn a_five_bar_whose_unknown_cranks_are_geared() {
    let (mut open, mut tied) = (rolling::GearedFiveBar::new(), rolling::TiedFiveBar::new());
    let (mut worst, mut followed) = (0.0_f64, 0);
    open.move_to([1e-3]).unwrap();
    let forwards = open.c().signum();
    for step in 1..=300 {
        let last = open.c();
        open.move_to([2e-3 * f64::from(step)]).unwrap();
        if (open.c() - last) * forwards < 1e-5 {
            break;
        }
        tied.move_to([open.c()]).unwrap();
        followed += 1;
        for (open, tied) in [
            (open.left(), tied.left()),
            (open.right(), tied.right()),
            (open.arm(), tied.arm()),
        ] {
            worst = worst.max((open.rotation.angle() - tied.rotation.angle()).abs());
            worst = worst.max((open.translation.vector - tied.translation.vector).norm());
        }
        assert!(
            (tied.e() - 1.5 * tied.a()).abs() < 1e-13,
            "the gear keeps its ratio"
        );
    }
    println!("geared five-bar: {worst:.1e} over {followed} positions");
    assert!(followed > 50 && worst < 1e-12, "{worst:e} over {followed}");
}
