//! Coordinates that are asked to be continuous, of any joint.

use super::by_hand::{Follower, near, part, principal};
use super::moves;
use super::subjects::{behind, drag_link, geared, meshing};
use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointId, JointKind, Model};
use mech_runtime::{Phase, mechanism};
use mech_test_support::{Dice, grow, model};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// Makes each of these moves at once, and by hand in steps of this length: all coordinates are the same.
fn follow(model: &Model, moves: &[Vec<f64>], step: f64, about: &str) {
    let compiled = compile(model).unwrap_or_else(|wrong| panic!("{wrong:?}\n{about}"));
    let program = &compiled.program;
    let mut machine = Machine::<f64>::new(program);
    let joints = model.continuous_joints();
    let slow = Machine::<f64>::new(program);
    let mut slow = Follower::new(model, slow, &joints, step);
    for by in moves {
        let to = part(&machine.position().motors, by, 1.0);
        let went = machine.move_to(&to).is_ok();
        assert_eq!(went, slow.move_by(by), "{about}");
        if !went {
            return;
        }
        for (joint, angle) in joints.iter().zip(&slow.angles) {
            let state = program.angle_state(*joint).expect("it is carried");
            let reported = machine.position().state[state];
            let name = &model.joint(*joint).name;
            assert!(
                (reported - angle).abs() < 1e-6 * (1.0 + angle.abs()),
                "{name} is reported to be at {reported}, by hand {angle}\n{about}\n{moves:?}"
            );
            let exact = near(principal(model, *joint, machine.position()), reported);
            assert!(
                (reported - exact).abs() < 1e-9 * (1.0 + reported.abs()),
                "{name} is reported to be at {reported}, but looks like {exact}\n{about}\n{moves:?}"
            );
        }
    }
}

fn follow_text(text: &str, moves: &[Vec<f64>], step: f64) {
    follow(&model(text), moves, step, text);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    #[test]
    fn drag_links_go_on(lengths in prop::array::uniform3(2.0..3.0), moves in moves(1)) {
        let asked = "continuous a, b, c, d;";
        follow_text(&drag_link(lengths, ["a", "b", "c", "d"], asked), &moves, 0.05);
    }

    #[test]
    fn gears_go_on(
        [p, q] in prop::array::uniform2(1..60_i32), inside in any::<bool>(), moves in moves(2),
    ) {
        let asked = "continuous wheel, pin;";
        follow_text(&geared(meshing(p, q, inside), ["wheel", "pin"], asked), &moves, 0.05 / 60.0);
    }

    #[test]
    fn wheels_and_cams_behind_loops_go_on(
        lengths in prop::array::uniform3(2.0..3.0),
        (cam, turns) in (any::<bool>(), -2..3_i32), moves in moves(1),
    ) {
        let by = if cam {
            format!("joint f = cam(d, wheel_pin, {turns} * q + sin(q));")
        } else {
            "joint f = gear(rocker, wheel, 30 : 20);".to_owned()
        };
        follow_text(&behind(lengths, "wheel_pin", &by, "continuous d, wheel_pin;"), &moves, 0.02);
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

mechanism! {
    /// A drag link whose rocker drives a wheel; what is not asked for is not there.
    struct Drag;
    ground { point a = (0, 0); point d = (0.8, 0); }
    link crank { point a = (0, 0); point b = (2.2, 0); }
    link coupler { point b = (0, 0); point c = (2.6, 0); }
    link rocker { point d = (0, 0); point c = (2.4, 0); }
    link wheel;
    joint a = revolute(ground.a, crank.a); joint b = revolute(crank.b, coupler.b);
    joint c = revolute(coupler.c, rocker.c); joint d = revolute(ground.d, rocker.d);
    joint w = revolute(ground, wheel) at (9, 0);
    joint mesh = gear(rocker, wheel, 30 : 17);
    motor a; start { a = 60 deg; coupler near -60 deg; }
    continuous c, d, w;
    show c, d, w, rocker;
    effects { velocity; }
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

mechanism! {
    /// The same without a statement.
    struct Wrapped;
    ground { point a = (0, 0); point d = (0.8, 0); }
    link crank { point a = (0, 0); point b = (2.2, 0); }
    link coupler { point b = (0, 0); point c = (2.6, 0); }
    link rocker { point d = (0, 0); point c = (2.4, 0); }
    joint a = revolute(ground.a, crank.a); joint b = revolute(crank.b, coupler.b);
    joint c = revolute(coupler.c, rocker.c); joint d = revolute(ground.d, rocker.d);
    motor a; start { a = 60 deg; coupler near -60 deg; }
}

#[test]
fn without_being_asked_nothing_is_carried() {
    let mut wrapped = Wrapped::new();
    let first = wrapped.d();
    wrapped
        .move_to([wrapped.motors()[0] + TAU])
        .expect("it turns");
    assert!((wrapped.d() - first).abs() < 1e-9);
    assert!(size_of::<Wrapped>() < size_of::<Drag>());
}
