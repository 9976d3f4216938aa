//! Coordinates over any number of turns, and torsional springs: they go on where they are, whatever path a mechanism takes. They are
//! followed by hand, in small steps; torques are slopes of the energy.

mod follow;

use follow::follow;
use mech_compiler::model::{JointId, JointKind};
use mech_runtime::{GaussLegendre, Phase};
use mech_test_support::{Dice, four_bar, grow, model};
use proptest::prelude::*;
use std::cmp::Ordering;
use std::f64::consts::{PI, TAU};

include!(concat!(env!("OUT_DIR"), "/turns.rs"));

/// Moves of so many motors, one after the other.
fn moves(motors: usize) -> impl Strategy<Value = Vec<Vec<f64>>> {
    prop::collection::vec(prop::collection::vec(-16.0..16.0, motors), 1..5)
}

fn follow_text(text: &str, moves: &[Vec<f64>], step: f64) {
    follow(&model(text), moves, step, text);
}

/// These joints are continuous, and on one of them is a spring; in some cases there is none.
fn asked(joints: &[&str], sprung: Option<(usize, f64)>) -> String {
    let spring = sprung.map_or(String::new(), |(joint, rest)| {
        let joint = joints[joint % joints.len()];
        format!("spring coil = torsional({joint}) stiffness 2 rest {rest}; effects {{ force; dynamics; }}")
    });
    format!("continuous {}; {spring}", joints.join(", "))
}

fn sprung() -> impl Strategy<Value = Option<(usize, f64)>> {
    prop::option::weighted(0.75, (0..4_usize, -20.0..20.0))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 18, ..ProptestConfig::default() })]

    /// The ground is the shortest, so that all links turn all the way round.
    #[test]
    fn drag_links_go_on(
        lengths in prop::array::uniform3(2.0..3.0), sprung in sprung(), moves in moves(1),
    ) {
        let joints = ["a", "b", "c", "d"];
        follow_text(&drag_link(lengths, &asked(&joints, sprung)), &moves, 0.05);
    }

    /// Wheels on each other, and planets that turn on an arm and follow two motors.
    #[test]
    fn gears_go_on(
        [p, q] in prop::array::uniform2(1..60_i32), inside in any::<bool>(), sprung in sprung(), moves in moves(2),
    ) {
        let asked = asked(&["wheel", "pin"], sprung);
        follow_text(&geared(meshing(p, q, inside), &asked), &moves, 0.05 / 60.0);
    }

    /// A wheel that a drag link turns, and another one that a cam turns.
    #[test]
    fn wheels_and_cams_behind_loops_go_on(
        lengths in prop::array::uniform3(2.0..3.0),
        (cam, turns) in (any::<bool>(), -2..3_i32), sprung in sprung(), moves in moves(1),
    ) {
        let by = if cam {
            format!("joint f = cam(d, wheel_pin, {turns} * q + sin(q));")
        } else {
            "joint f = gear(rocker, wheel, 30 : 20);".to_owned()
        };
        let asked = asked(&["wheel_pin", "d"], sprung.map(|(_, rest)| (0, rest)));
        follow_text(&behind(lengths, &by, &asked), &moves, 0.02);
    }

    /// Every joint that turns, of anything.
    #[test]
    fn random_mechanisms_go_on(seed in any::<u64>(), additions in 1..6_usize, moves in moves(1)) {
        let mut model = grow(&mut Dice::new(seed), additions).model;
        let turns = |&joint: &JointId| matches!(model.joint(joint).kind, JointKind::Revolute(..)) && !model.joint(joint).hidden;
        model.continuous = model.joint_ids().filter(turns).collect();
        follow(&model, &moves, 0.01, &format!("seed {seed}, {additions} additions"));
    }
}

#[test]
fn the_methods_of_joints_count_turns_in_both_directions() {
    let mut drag = Drag::new();
    let start = drag.motors()[0];
    let first = [drag.c(), drag.d(), drag.w()];
    for turns in [1, 3, -2, 0, 400, 0] {
        let whole = TAU * f64::from(turns);
        for exactly in [false, true] {
            if exactly {
                let to = Phase::from_radians(start + whole).expect("a phase");
                drag.turn_to([to]).expect("it turns");
            } else {
                drag.move_with([start + whole], [1.0]).expect("it turns");
            }
            // The coupler and the rocker turn with the crank, as all links do where the ground is the shortest.
            assert!((drag.c() - first[0]).abs() < 1e-9, "{}", drag.c());
            assert!((drag.d() - first[1] - whole).abs() < 1e-9, "{}", drag.d());
            let wheel = first[2] - whole * 30.0 / 17.0;
            assert!((drag.w() - wheel).abs() < 1e-8, "{}", drag.w());
        }
    }
}

#[test]
fn without_being_asked_nothing_is_carried() {
    let mut wrapped = Wrapped::new();
    let first = wrapped.d();
    wrapped.move_to([wrapped.motors()[0] + TAU]).expect("it turns");
    assert!((wrapped.d() - first).abs() < 1e-9);
    assert!(size_of::<Wrapped>() < size_of::<Drag>());
}

four_bar! {
    /// A crank rocker whose spring is wound from the start.
    struct Wound: f64;
    motor a;
    spring coil = torsional(d) stiffness 1 rest 6;
    effects { force; }
}

#[test]
fn a_spring_that_rests_far_beyond_half_a_turn_pulls_on() {
    let mut wound = Wound::new();
    for turns in -3..=3 {
        let at = TAU * f64::from(turns) + 0.7;
        let mut energy = |angle: f64| {
            wound.move_to([angle]).expect("it turns");
            0.5 * (wound.d() - 6.0).powi(2)
        };
        let slope = (energy(at + 1e-5) - energy(at - 1e-5)) / 2e-5;
        let [torque] = wound.hold_at([at]).expect("regular");
        assert!((torque - slope).abs() < 1e-8, "{torque}, slope {slope}");
    }
}

#[test]
fn energy_stays_the_same_through_half_turns() {
    let mut coiled = Coiled::new();
    coiled.set_rates([6.0]).expect("a number");
    let start: f64 = coiled.energy().expect("regular").iter().sum();
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for _ in 0..8000 {
        coiled.simulate_by(GaussLegendre::Order6, 0.004, [0.0]).expect("it turns");
        let energy: f64 = coiled.energy().expect("regular").iter().sum();
        assert!((energy / start - 1.0).abs() < 1e-9, "{energy}, not {start}");
        least = least.min(coiled.d());
        most = most.max(coiled.d());
    }
    // The springs stop it, several turns from where it came.
    assert!(most - least > 4.0 * PI, "{least} to {most}");
}

#[test]
fn coordinates_with_springs_count_turns_in_both_directions() {
    let mut coiled = Coiled::new();
    let start = coiled.motors()[0];
    let first = [coiled.d(), coiled.w()];
    for turns in [1, 3, -2, 0] {
        let whole = TAU * f64::from(turns);
        coiled.move_to([start + whole]).expect("it turns");
        let wheel = first[1] - whole * 30.0 / 17.0;
        assert!((coiled.d() - first[0] - whole).abs() < 1e-9);
        assert!((coiled.w() - wheel).abs() < 1e-9, "{}", coiled.w());
        coiled.turn_to([Phase::from_radians(start + whole).expect("a phase")]).expect("it turns");
        assert!((coiled.d() - first[0] - whole).abs() < 1e-9);
        assert!((coiled.w() - wheel).abs() < 1e-9, "{}", coiled.w());
    }
}

/// A drag link with these lengths: the ground is the shortest, so that all links turn all the way round. What is asked of it is put at its end.
fn drag_link([crank, coupler, rocker]: [f64; 3], asked: &str) -> String {
    format!(
        "struct Drag;
        ground {{ point a = (0, 0); point d = (0.8, 0); point w = (9, 0); }}
        link crank {{ point a = (0, 0); point b = ({crank}, 0); mass 1 at (0, 0) inertia 1; }}
        link coupler {{ point b = (0, 0); point c = ({coupler}, 0); }}
        link rocker {{ point d = (0, 0); point c = ({rocker}, 0); }}
        joint a = revolute(ground.a, crank.a); joint b = revolute(crank.b, coupler.b);
        joint c = revolute(coupler.c, rocker.c); joint d = revolute(ground.d, rocker.d);
        motor a; start {{ a = 60 deg; coupler near -60 deg; }}
        {asked}"
    )
}

/// A wheel and a planet on an arm, of sizes in this ratio, which follow two motors.
fn geared([p, q]: [i32; 2], asked: &str) -> String {
    let planet = f64::from(p + q).abs().max(1.0);
    let shaft = f64::from(p + q);
    format!(
        "struct Geared;
        ground {{ point o = (0, 0); point w = ({shaft}, 0); }}
        link sun {{ point o = (0, 0); mass 1 at (0, 0) inertia 1; }} link arm {{ point o = (0, 0); point p = ({planet}, 0); mass 1 at (0, 0) inertia 1; }}
        link planet {{ point p = (0, 0); }} link big {{ point w = (0, 0); }}
        joint s = revolute(ground.o, sun.o); joint r = revolute(ground.o, arm.o);
        joint pin = revolute(arm.p, planet.p); joint wheel = revolute(ground.w, big.w);
        joint inner = gear(sun, planet, {p} : {q}); joint outer = gear(sun, big, {q} : {p});
        motor s; motor r;
        {asked}"
    )
}

/// A drag link that turns a wheel by this joint.
fn behind(lengths: [f64; 3], by: &str, asked: &str) -> String {
    let wheel = "link wheel { point w = (0, 0); } joint wheel_pin = revolute(ground.w, wheel.w);";
    drag_link(lengths, &format!("{wheel} {by} {asked}"))
}

/// The same ratio with the ring the larger, if it is one.
fn meshing(p: i32, q: i32, inside: bool) -> [i32; 2] {
    match (inside, p.cmp(&q)) {
        (true, Ordering::Less) => [p, -q],
        (true, Ordering::Greater) => [-p, q],
        _ => [p, q],
    }
}
