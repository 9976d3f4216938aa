//! The generated code beside the interpreted program, and both beside the definition of the joints.

use super::zoo;
use mech_compiler::evaluate::Machine;
use mech_runtime::{Mechanism, Real};
use mech_test_support::{in_f64, lengths, mechanism_of, with_ground, worst_gap, worst_stretch};
use std::f64::consts::{PI, TAU};

const FRAMES: i32 = 360;

/// What to hold a mechanism to.
struct Case<'s> {
    source: &'s str,
    /// The values of the motors at a phase in 0..=1, beside those of the start.
    motion: fn(f64) -> Vec<f64>,
}

/// Moves both through a full motion: same bits or 4 ulp; every joint closed.
fn check<M>(case: &Case<'_>, gap_limit: f64)
where
    M: Mechanism,
    M::Scalar: Real,
{
    let (model, compiled) = mechanism_of::<M>(case.source);
    let mut machine = Machine::<M::Scalar>::new(&compiled.program);
    let mut mechanism = M::new();
    let start: Vec<f64> =
        mechanism.motors().as_ref().iter().map(|&motor| Real::to_f64(motor)).collect();
    let mut worst: f64 = 0.0;
    for frame in 0..=FRAMES {
        let phase = f64::from(frame) / f64::from(FRAMES);
        let mut motors = mechanism.motors();
        for ((motor, start), displacement) in
            motors.as_mut().iter_mut().zip(&start).zip((case.motion)(phase))
        {
            *motor = <M::Scalar as Real>::from_f64(start + displacement);
        }
        mechanism
            .move_to(motors)
            .unwrap_or_else(|blocked| panic!("{} at {phase}: {blocked}", M::NAME));
        machine
            .move_to(motors.as_ref())
            .unwrap_or_else(|stop| panic!("{} at {phase}: {stop:?}", M::NAME));
        for (emitted, run) in mechanism.poses().iter().zip(&machine.position().poses) {
            for (emitted, run) in
                [emitted.cos, emitted.sin, emitted.x, emitted.y].into_iter().zip(run)
            {
                let (emitted, run) = (Real::to_f64(emitted), Real::to_f64(*run));
                let ulp = <M::Scalar as Real>::EPSILON * emitted.abs().max(f64::MIN_POSITIVE);
                assert!(
                    (emitted - run).abs() <= 4.0 * ulp,
                    "{} at {phase}: {emitted} and {run}",
                    M::NAME
                );
            }
        }
        let poses = with_ground(&model, &in_f64(mechanism.poses()));
        worst = worst.max(worst_gap(&model, &poses));
        assert!(worst_stretch(&poses) < 8.0 * <M::Scalar as Real>::EPSILON);
    }
    let relative = worst / lengths(&model).fold(0.0, f64::max);
    println!("{:<16} gap at most {relative:.1e} of its largest length", M::NAME);
    assert!(relative < gap_limit, "{}: {relative:e}", M::NAME);
}

macro_rules! cases {
    ($($test:ident: $mechanism:ty, $source:literal, $motion:expr;)*) => {
        $(
            #[test]
            fn $test() {
                let case = Case { source: include_str!($source), motion: $motion };
                check::<$mechanism>(&case, 1e-13);
            }
        )*
    };
}

fn turn(phase: f64) -> Vec<f64> {
    vec![phase * TAU]
}

fn to_and_fro(phase: f64) -> Vec<f64> {
    vec![-1.2 * (phase * PI).sin()]
}

fn nudge(phase: f64) -> Vec<f64> {
    vec![0.05 * (phase * TAU).sin()]
}

fn to(phase: f64) -> Vec<f64> {
    vec![0.3 * (phase * PI).sin()]
}

fn swing(phase: f64) -> Vec<f64> {
    vec![0.3 * (phase * TAU).sin()]
}

fn turn_both(phase: f64) -> Vec<f64> {
    vec![phase * TAU, 0.4 * (phase * TAU).sin()]
}

fn turn_all_three(phase: f64) -> Vec<f64> {
    vec![phase * TAU, (phase * TAU).sin(), -2.0 * (phase * TAU).sin()]
}

cases! {
    geared_piston: mech_gallery::geared_piston::GearedPiston, "../../examples/gallery/src/mechanisms/geared_piston.rs", |phase| vec![2.0 * phase * TAU];
    crank_rocker: mech_gallery::four_bar::CrankRocker, "../../examples/gallery/src/mechanisms/four_bar.rs", turn;
    watt: mech_gallery::watt::Watt, "../../examples/gallery/src/mechanisms/watt.rs", turn;
    andrews: mech_gallery::andrews::AndrewsSqueezer, "../../examples/gallery/src/mechanisms/andrews.rs", turn;
    jansen: mech_gallery::jansen::JansenLeg, "../../examples/gallery/src/mechanisms/jansen.rs", turn;
    rocker_arm: mech_gallery::rocker_arm::RockerArm, "../../examples/gallery/src/mechanisms/rocker_arm.rs", turn_all_three;
    slanted_guide: zoo::SlantedGuide, "subjects/zoo/slanted_guide.mech", turn;
    quick_return: zoo::QuickReturn, "subjects/zoo/quick_return.mech", turn;
    trammel: zoo::Trammel, "subjects/zoo/trammel.mech", to_and_fro;
    scotch_yoke: zoo::ScotchYoke, "subjects/zoo/scotch_yoke.mech", turn;
    rider: zoo::Rider, "subjects/zoo/rider.mech", turn_both;
    gear_on_rocker: zoo::GearOnRocker, "subjects/zoo/gear_on_rocker.mech", turn;
    planetary: zoo::Planetary, "subjects/zoo/planetary.mech", turn;
    differential: zoo::Differential, "subjects/zoo/differential.mech", turn_both;
    clock: zoo::Clock, "subjects/zoo/clock.mech", turn;
    two_racks: zoo::TwoRacks, "subjects/zoo/two_racks.mech", to_and_fro;
    rolling_wheel: zoo::Rolling, "subjects/zoo/rolling.mech", to_and_fro;
    geared_five_bar: zoo::GearedFiveBar, "subjects/zoo/geared_five_bar.mech", swing;
    tied_five_bar: zoo::TiedFiveBar, "subjects/zoo/tied_five_bar.mech", nudge;
    slotted_arm: zoo::SlottedArm, "subjects/zoo/slotted_arm.mech", turn;
    welded: zoo::Welded, "subjects/zoo/welded.mech", turn;
    wedge: zoo::Wedge, "subjects/zoo/wedge.mech", to_and_fro;
    three_cranks: zoo::ThreeCranks, "subjects/zoo/three_cranks.mech", swing;
    two_guides: zoo::TwoGuides, "subjects/zoo/two_guides.mech", turn;
    four_gears: zoo::FourGears, "subjects/zoo/four_gears.mech", turn;
    three_planets: zoo::ThreePlanets, "subjects/zoo/three_planets.mech", turn;
    stephenson_from_its_far_side: zoo::StephensonFar, "subjects/zoo/stephenson_far.mech", to;
    double_butterfly: zoo::DoubleButterfly, "subjects/zoo/double_butterfly.mech", swing;
}

#[test]
fn single_precision() {
    let case = Case { source: include_str!("subjects/zoo/single.mech"), motion: turn };
    check::<zoo::Single>(&case, 1e-6);
}

/// The pointer's turns against the rocker's, by the ratio alone: the rocker's angle does not leave (−π, π].
#[test]
fn a_gear_follows_a_rocker() {
    let mut mechanism = zoo::GearOnRocker::new();
    for degree in 0..3600 {
        mechanism.move_to([f64::from(degree).to_radians()]).unwrap();
        let wheel = mechanism.d() * 60.0 / 13.0;
        let pointer = -1.5 * wheel;
        for (link, angle) in [(mechanism.wheel(), wheel), (mechanism.pointer(), pointer)] {
            let off = link.rotation.angle() - angle;
            let off = off - TAU * (off / TAU).round();
            assert!(off.abs() < 1e-13, "{degree}: {off:e}");
        }
    }
}

/// A rider moved as a whole: the poses of its parts relative to their carrier do not depend on where the carrier is.
#[test]
fn a_loop_on_a_moving_carrier_is_the_same_loop() {
    let (mut still, mut moved) = (zoo::Rider::new(), zoo::Rider::new());
    for degree in 0..360 {
        let angle = f64::from(degree).to_radians();
        still.move_to([angle, 0.0]).unwrap();
        moved.move_to([angle, 2.0 * angle]).unwrap();
        let seen = moved.carrier().inverse() * moved.rocker();
        let off = (seen.translation.vector - still.rocker().translation.vector).norm();
        assert!(off < 1e-13, "{degree}: {off:e}");
        assert!((seen.rotation.angle() - still.rocker().rotation.angle()).abs() < 1e-13);
    }
}

#[test]
fn nobody_sees_the_die_of_a_slot() {
    assert_eq!(zoo::SlottedArm::LINKS, ["crank", "arm"]);
}
