//! Torsional springs: torques are slopes of the energy, over any number of turns.

use super::by_hand::{Follower, near, part, principal};
use super::moves;
use super::subjects::{behind, drag_link, geared, meshing};
use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::program::{Forces, Position};
use mech_runtime::{GaussLegendre, Phase, mechanism};
use mech_test_support::{four_bar, model};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// Moves through random targets and compares, at each, with a second machine that goes there in steps of this length.
fn follow(text: &str, moves: &[Vec<f64>], step: f64) {
    let model = model(text);
    let compiled = compile(&model).unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"));
    let inertia = compiled.forced.inertia.as_ref().expect("asked for");
    let holding = compiled.forced.holding.as_ref().expect("asked for");
    let spring = &model.actions.springs[0];
    let joint = model
        .joint_ids()
        .find(|&id| model.joint(id).name == "sprung")
        .expect("a joint of this name");
    let mut machine = Machine::<f64>::new(&compiled.program);
    let slow = Machine::<f64>::new(&compiled.program);
    let mut slow = Follower::new(&model, slow, &[joint], step);
    for by in moves {
        let to = part(&machine.position().motors, by, 1.0);
        machine
            .move_to(&to)
            .unwrap_or_else(|stop| panic!("{stop:?}\n{text}"));
        assert!(slow.move_by(by), "{text}");
        let angle = slow.angles[0];
        let potential = |position: &Position<f64>| {
            let mut machine = Machine::<f64>::new(inertia);
            machine.put_back(position.clone());
            let rates = vec![0.0; by.len()];
            match machine.forces(&rates, &rates, &[]) {
                Ok(Forces::Inertia(felt)) => felt.energy[1],
                other => panic!("{other:?}\n{text}"),
            }
        };
        let by_hand = |angle: f64| spring.stiffness / 2.0 * (angle - spring.rest).powi(2);
        let (reported, expected) = (potential(machine.position()), by_hand(angle));
        assert!(
            (reported - expected).abs() <= 1e-8 * (1.0 + expected),
            "energy {reported}, by hand {expected} at {angle}\n{text}\n{moves:?}"
        );
        let mut held = Machine::<f64>::new(holding);
        held.put_back(machine.position().clone());
        let zero = vec![0.0; by.len()];
        let Ok(Forces::Holding(torques)) = held.forces(&zero, &zero, &[]) else {
            panic!("{text}");
        };
        for (motor, torque) in torques.iter().enumerate() {
            let h = 1e-4 * step;
            let energy = |by: f64| {
                let mut machine = slow.machine.clone();
                let mut to = machine.position().motors.clone();
                to[motor] += by;
                machine.move_to(&to).expect("so near");
                by_hand(near(principal(&model, joint, machine.position()), angle))
            };
            let slope = (8.0 * (energy(h) - energy(-h)) - (energy(2.0 * h) - energy(-2.0 * h)))
                / (12.0 * h);
            let rounding = 1e-14 * expected / h + 1e-6 * (1.0 + slope.abs());
            assert!(
                (torque - slope).abs() <= rounding,
                "torque {torque}, slope {slope} at {angle}\n{text}\n{moves:?}"
            );
        }
    }
}

/// A spring at the joint `sprung`, and what shows that it pulls.
fn coil(rest: f64) -> String {
    format!(
        "spring coil = torsional(sprung) stiffness 2 rest {rest}; effects {{ force; dynamics; }}"
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    /// A drag link: the ground is the shortest, so that all links turn all the way round.
    #[test]
    fn springs_in_drag_links_go_on(
        [crank, coupler, rocker] in prop::array::uniform3(2.0..3.0),
        at in 0..4_usize, rest in -20.0..20.0, moves in moves(1),
    ) {
        let joints = std::array::from_fn(|joint| if joint == at { "sprung" } else { ["a", "b", "c", "d"][joint] });
        let text = drag_link([crank, coupler, rocker], joints, &coil(rest));
        follow(&text, &moves, 0.05);
    }

    /// Wheels on each other, and planets that turn on an arm and follow two motors.
    #[test]
    fn springs_behind_gears_go_on(
        [p, q] in prop::array::uniform2(1..60_i32), inside in any::<bool>(), at in 0..2_usize,
        rest in -20.0..20.0, moves in moves(2),
    ) {
        let joints = std::array::from_fn(|joint| if joint == at { "sprung" } else { ["wheel", "pin"][joint] });
        follow(&geared(meshing(p, q, inside), joints, &coil(rest)), &moves, 0.05 / 60.0);
    }

    /// A wheel that a drag link turns, and another one that a cam turns.
    #[test]
    fn springs_behind_loops_and_cams_go_on(
        [crank, coupler, rocker] in prop::array::uniform3(2.0..3.0),
        (cam, turns) in (any::<bool>(), -2..3_i32), rest in -20.0..20.0, moves in moves(1),
    ) {
        let by = if cam {
            format!("joint f = cam(d, sprung, {turns} * q + sin(q));")
        } else {
            "joint f = gear(rocker, wheel, 30 : 20);".to_owned()
        };
        follow(&behind([crank, coupler, rocker], "sprung", &by, &coil(rest)), &moves, 0.02);
    }
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

mechanism! {
    /// A flywheel that winds a spring through a wheel and one through a drag link.
    struct Coiled;
    ground { point a = (0, 0); point d = (0.8, 0); point w = (9, 0); }
    link crank { point a = (0, 0); point b = (2.2, 0); mass 1 at (0.3, 0.1) inertia 1.5; }
    link coupler { point b = (0, 0); point c = (2.6, 0); mass 0.2 at (1, 0) inertia 0.1; }
    link rocker { point d = (0, 0); point c = (2.4, 0); mass 0.3 at (1, 0) inertia 0.2; }
    link wheel { point w = (0, 0); mass 0.1 at (0, 0) inertia 0.3; }
    joint a = revolute(ground.a, crank.a); joint b = revolute(crank.b, coupler.b);
    joint c = revolute(coupler.c, rocker.c); joint d = revolute(ground.d, rocker.d);
    joint w = revolute(ground.w, wheel.w);
    joint mesh = gear(crank, wheel, 30 : 17);
    motor a; start { a = 60 deg; coupler near -60 deg; }
    spring outer = torsional(w) stiffness 0.02 rest 12;
    spring inner = torsional(d) stiffness 0.05 rest -8;
    spring own = torsional(a) stiffness 0.01 rest 7;
    effects { force; dynamics; }
}

#[test]
fn energy_stays_the_same_through_half_turns() {
    let mut coiled = Coiled::new();
    coiled.set_rates([6.0]).expect("a number");
    let start: f64 = coiled.energy().expect("regular").iter().sum();
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for _ in 0..8000 {
        coiled
            .simulate_by(GaussLegendre::Order6, 0.004, [0.0])
            .expect("it turns");
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
        coiled
            .turn_to([Phase::from_radians(start + whole).expect("a phase")])
            .expect("it turns");
        assert!((coiled.d() - first[0] - whole).abs() < 1e-9);
        assert!((coiled.w() - wheel).abs() < 1e-9, "{}", coiled.w());
    }
}
