//! Wheels fit where their axes are, or the error offers sizes that do; what they turn goes on over any number of turns.

use mech_compiler::evaluate::Machine;
use mech_compiler::structure::{Diagnosis, MeshTrouble};
use mech_compiler::syntax::Parsed;
use mech_compiler::{compile, repair, reporter};
use mech_test_support::{model, parsed};
use proptest::prelude::*;
use std::f64::consts::TAU;

include!(concat!(env!("OUT_DIR"), "/mesh.rs"));

/// Two wheels on the ground, the axes as far apart as said.
fn text(distance: [f64; 2], sizes: &str) -> String {
    let [x, y] = distance;
    format!(
        "struct Gears; link pinion; link wheel;
        ground {{ point a = (0.25, 0.5); point b = ({}, {}); }}
        link pinion_arm {{ point tip = (0, 0); }}
        joint a = revolute(ground, pinion) at (0.25, 0.5);
        joint b = revolute(ground, wheel) at ({}, {});
        joint c = weld(pinion, pinion_arm) at (1, 1);
        joint mesh = gear(pinion, wheel, {sizes});
        motor a;",
        0.25 + x,
        0.5 + y,
        0.25 + x,
        0.5 + y
    )
}

fn trouble(text: &str) -> Option<MeshTrouble> {
    match compile(&model(text)).err()?.as_slice() {
        [Diagnosis::NoMesh { trouble, .. }] => Some(*trouble),
        other => panic!("{other:?}"),
    }
}

/// Everything in backticks that is two sizes.
fn offers(message: &str) -> Vec<String> {
    let quoted = message.split('`').skip(1).step_by(2);
    quoted.filter(|text| text.contains(" : ")).map(str::to_owned).collect()
}

/// How far the wheel turns with its pinion.
fn turns(text: &str) -> f64 {
    let compiled = compile(&model(text)).expect("wheels that mesh");
    let mut machine = Machine::<f64>::new(&compiled.program);
    let angle = |machine: &Machine<f64>| {
        let pose = machine.position().poses[1];
        f64::atan2(pose[1], pose[0])
    };
    let before = angle(&machine);
    machine.move_to(&[0.001]).expect("it turns");
    (angle(&machine) - before) / 0.001
}

/// The sizes of a text like `1.5 : -3.0`.
fn sizes(text: &str) -> [f64; 2] {
    let (a, b) = text.split_once(" : ").expect("two sizes");
    [a, b].map(|size| size.parse().expect("a number"))
}

proptest! {
    #[test]
    fn radii_fit_where_they_add_up_to_the_distance(
        offset in prop::array::uniform2(0.5..4.0), share in 0.05..0.95,
    ) {
        let distance = f64::hypot(offset[0], offset[1]);
        let (a, b) = (distance * share, distance * (1.0 - share));
        prop_assert_eq!(trouble(&text(offset, &format!("{a:?} : {b:?}"))), None);
        // As rounded as a drawing.
        prop_assert_eq!(trouble(&text(offset, &format!("{a:.5} : {b:.5}"))), None);
        // A ring around a wheel.
        let (wheel, ring) = (a, a + distance);
        prop_assert_eq!(trouble(&text(offset, &format!("{wheel:?} : -{ring:?}"))), None);
        prop_assert_eq!(trouble(&text(offset, &format!("-{ring:?} : {wheel:?}"))), None);
    }

    #[test]
    fn what_is_offered_meshes(
        offset in prop::array::uniform2(0.5..4.0), [a, b] in prop::array::uniform2(0.1..6.0), inside in any::<bool>(),
    ) {
        let distance = f64::hypot(offset[0], offset[1]);
        let written = if inside { format!("{a:.2} : -{b:.2}") } else { format!("{a:.2} : {b:.2}") };
        let [a, b] = sizes(&written);
        prop_assume!(((a + b).abs() - distance).abs() > 0.01 && (a + b).abs() > 0.01);
        let wrong = text(offset, &written);
        prop_assert!(trouble(&wrong).is_some());
        let Parsed { model, places, source, .. } = parsed(&wrong);
        let diagnoses = compile(&model).expect_err("it does not mesh");
        let found = repair::offers(&model, &source, &diagnoses);
        let message = &reporter::messages(&diagnoses, &found, &model, &places)[0].text;
        let offers = offers(message);
        let small_ring = inside && a + b >= 0.0;
        prop_assert!(!offers.is_empty() || small_ring, "{}", message);
        for offer in offers {
            let [first, second] = sizes(&offer);
            let found = turns(&text(offset, &offer));
            prop_assert!((found + first / second).abs() < 1e-8, "{} turns by {}", offer, found);
        }
    }

    #[test]
    fn teeth_fit_at_any_distance(
        offset in prop::array::uniform2(0.01..400.0), [a, b] in prop::array::uniform2(1..90_u8),
    ) {
        prop_assert_eq!(trouble(&text(offset, &format!("{a} : {b}"))), None);
        if a != b {
            let (wheel, ring) = (a.min(b), a.max(b));
            prop_assert_eq!(trouble(&text(offset, &format!("{wheel} : -{ring}"))), None);
            let inside_out = trouble(&text(offset, &format!("{ring} : -{wheel}")));
            prop_assert_eq!(inside_out, Some(MeshTrouble::SmallRing));
        }
    }
}

#[test]
fn wheels_on_one_shaft_do_not_mesh() {
    for sizes in ["20 : 40", "1.0 : 2.0"] {
        assert_eq!(trouble(&text([0.0; 2], sizes)), Some(MeshTrouble::OneShaft));
    }
    let belt = text([0.0; 2], "20 : 40").replace("gear(", "belt(");
    assert_eq!(trouble(&belt), Some(MeshTrouble::OneShaft));
}

/// By how much two angles differ, apart from whole turns.
fn apart(a: f64, b: f64) -> f64 {
    let turns = (a - b) / TAU;
    (turns - turns.round()).abs() * TAU
}

proptest! {
    /// Coordinates that follow motors through gears go on as these do: half a turn on they are not wrapped.
    #[test]
    fn coordinates_behind_gears_go_on(dates in prop::collection::vec(prop::array::uniform2(-40.0..40.0_f64), 1..6)) {
        let mut clock = Clock::new();
        let starts = [clock.b(), clock.c(), clock.d()];
        prop_assert!((starts[1] + 0.25).abs() < 1e-12 && (starts[2] - 20.0_f64.to_radians()).abs() < 1e-12);
        for [minute, date] in dates {
            clock.move_to([minute, date]).expect("nothing is in the way");
            let moved = minute - 0.5;
            // The hand is declared the other way round.
            prop_assert!((clock.b() - starts[0] + moved / 3.0).abs() < 1e-12 * (1.0 + moved.abs()));
            prop_assert!((clock.c() - starts[1] + moved / 12.0).abs() < 1e-12 * (1.0 + moved.abs()));
            let on_hand = date - moved / 12.0;
            let moon = starts[2] - 30.0 / 17.0 * on_hand;
            prop_assert!((clock.d() - moon).abs() < 1e-11 * (1.0 + moved.abs() + date.abs()));
            // They are the angles that are seen, apart from whole turns.
            let [layshaft, hour, moon] = [clock.layshaft(), clock.hour(), clock.moon()].map(|pose| pose.rotation.angle());
            prop_assert!(apart(clock.b(), layshaft) < 1e-9);
            prop_assert!(apart(clock.c(), -hour) < 1e-9);
            prop_assert!(apart(clock.d(), moon - hour) < 1e-9);
        }
    }
}
