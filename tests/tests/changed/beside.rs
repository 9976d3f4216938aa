//! Params beside laws, forces, motions under forces and overlays: held against the same mechanisms in which they are numbers.

use mech_runtime::overlay::Arrows;
use mech_runtime::{Blocked, Cause, Overlay, mechanism};
use mech_test_support::differences;

include!(concat!(env!("OUT_DIR"), "/beside.rs"));

/// A loaded four-bar of whose numbers two are params, or constants.
macro_rules! loaded {
    ($name:ident: $scalar:ident, $word:ident $crank:tt $rod:tt) => {
        mechanism! {
            struct $name: $scalar;
            $word crank_length = $crank;
            $word rod_length = $rod;
            ground { point a = (0, 0); point d = (4, 0); point hook = (rod_length / 2, 3); }
            link crank { point a = (0, 0); point b = (crank_length, 0); mass 1.5 at (0.25, 0.1) inertia 0.2; }
            link rod {
                point b = (0, 0); point c = (rod_length, 0); point tip = (rod_length / 2, floor(rod_length) / 3);
                mass 2 at (1.5, 0) inertia 1;
            }
            link rocker { point d = (0, 0); point c = (3, 0); mass 1 at (1.5, 0) inertia 0.75; }
            joint ja = revolute(ground.a, crank.a);
            joint jb = revolute(crank.b, rod.b);
            joint jc = revolute(rod.c, rocker.c);
            joint jd = revolute(ground.d, rocker.d);
            motor ja;
            start { ja = 40 deg; rod near 40 deg; }
            gravity (0, -9.81);
            spring pull = linear(ground.hook, rod.tip) stiffness 12 rest 0.5;
            spring coil = torsional(jd) stiffness 3 rest 60 deg;
            damper drag = linear(ground.hook, rod.tip) damping 0.4;
            load push = force(rod.tip);
            effects { velocity; acceleration; force; dynamics; overlay; }
        }
    };
}

loaded!(Changed: f64, param 1.0 3.5);
loaded!(Declared: f64, const 1.25 3.25);
loaded!(Small: f32, param 1.0 3.5);

const PARAMS: [f64; 2] = [1.25, 3.25];

#[track_caller]
fn near(found: f64, expected: f64, scale: f64) {
    let most = 1e-10 * (scale + expected.abs());
    assert!((found - expected).abs() <= most, "{found}, not {expected}");
}

#[test]
fn forces_are_those_of_a_mechanism_with_these_numbers() {
    let (mut changed, mut declared) = (Changed::new(), Declared::new());
    changed.set_params(PARAMS).expect("it closes");
    changed.set_push([3.0, -7.0]).expect("finite");
    declared.set_push([3.0, -7.0]).expect("finite");
    for step in 0..90 {
        let motors = [0.7 + 0.21 * f64::from(step)];
        let (held, expected) = (
            changed.hold_at(motors).expect("a crank turns"),
            declared.hold_at(motors).expect("a crank turns"),
        );
        near(held[0], expected[0], 100.0);
        assert_eq!(changed.torques().expect("regular"), held);
        near(changed.pull(), declared.pull(), 1.0);
        let (found, expected) = (
            changed.forces([2.0], [-1.0]).expect("regular"),
            declared.forces([2.0], [-1.0]).expect("regular"),
        );
        near(found.torques[0], expected.torques[0], 100.0);
        for (found, expected) in found.reactions.iter().zip(expected.reactions) {
            near(found.x, expected.x, 100.0);
            near(found.y, expected.y, 100.0);
        }
        let along = [1.0, 2.0];
        near(
            changed.push_advantage(along).expect("regular")[0].recip(),
            declared.push_advantage(along).expect("regular")[0].recip(),
            1.0,
        );
    }
}

#[test]
fn torques_are_slopes_of_the_energy() {
    const STEP: f64 = 1e-3;
    let mut changed = Changed::new();
    changed.set_params([0.8, 3.9]).expect("it closes");
    for step in 0..40 {
        let motor = 0.7 + 0.47 * f64::from(step);
        let energy = |part: f64| {
            let mut there = changed;
            there.hold_at([motor + part * STEP]).expect("it turns");
            there.energy().expect("regular")[1]
        };
        let energies = [-2.0, -1.0, 0.0, 1.0, 2.0].map(energy);
        let [slope, _] = differences(energies, STEP);
        let held = changed.hold_at([motor]).expect("it turns");
        assert!((held[0] - slope).abs() < 1e-7, "{held:?}, not {slope}");
    }
}

#[test]
fn it_moves_under_forces_as_a_mechanism_with_these_numbers() {
    let (mut changed, mut declared) = (Changed::new(), Declared::new());
    changed.set_params(PARAMS).expect("it closes");
    changed.move_to([0.7]).expect("it closes");
    declared.move_to([0.7]).expect("it closes");
    changed.set_rates([4.0]).expect("finite");
    declared.set_rates([4.0]).expect("finite");
    for _ in 0..200 {
        changed.simulate(0.005, [6.0]).expect("nothing is in the way");
        declared.simulate(0.005, [6.0]).expect("nothing is in the way");
        near(changed.motors()[0], declared.motors()[0], 100.0);
        near(changed.rates()[0], declared.rates()[0], 100.0);
        near(changed.rod_tip_velocity().x, declared.rod_tip_velocity().x, 100.0);
        near(
            changed.motor_accelerations([1.0]).expect("regular")[0],
            declared.motor_accelerations([1.0]).expect("regular")[0],
            100.0,
        );
        let [kinetic, potential] = changed.energy().expect("regular");
        let expected = declared.energy().expect("regular");
        near(kinetic, expected[0], 100.0);
        near(potential, expected[1], 100.0);
    }
    assert_eq!(changed.params(), PARAMS, "params stay");
    // Whoever changes the mechanism stops it.
    changed.set_rod_length(3.3).expect("it closes");
    assert_eq!(changed.rates(), [0.0]);
}

#[test]
fn what_is_wrong_with_forces_is_reported_of_motors() {
    let mut small = Small::new();
    let blocked = small.hold_at([f32::NAN]).expect_err("not a number");
    let Blocked { place, cause, reached, .. } = blocked;
    assert_eq!((place, cause), ("ja", Cause::NotFinite));
    assert_eq!(reached, small.motors());
    let blocked = small.simulate(0.1, [f32::INFINITY]).expect_err("not a number");
    assert_eq!(blocked.place, "ja");
    assert!(small.set_push([f32::NAN, 0.0]).is_err());
    small.set_crank_length(1.1).expect("it closes");
    small.simulate(0.01, [1.0]).expect("it moves");
}

#[test]
fn an_overlay_is_that_of_a_mechanism_with_these_numbers() {
    let (mut changed, mut declared) = (Changed::new(), Declared::new());
    changed.set_params(PARAMS).expect("it closes");
    for step in 0..5 {
        let motors = [0.7 + 0.9 * f64::from(step)];
        changed.move_with(motors, [1.0], [0.0]).expect("it turns");
        declared.move_with(motors, [1.0], [0.0]).expect("it turns");
        let mut picture = Declared::picture::<160, 120>();
        let mut expected = Declared::picture::<160, 120>();
        let (one, other) = (&mut picture, &mut expected);
        let overlay = Overlay::new().links(true).axes(true);
        changed.draw_overlay(one, &overlay);
        declared.draw_overlay(other, &overlay);
        let arrows = Arrows::new(0.3, 5);
        changed.draw_velocities(one, &arrows);
        declared.draw_velocities(other, &arrows);
        changed.draw_accelerations(one, &arrows);
        declared.draw_accelerations(other, &arrows);
        let forces = changed.forces([1.0], [0.0]).expect("regular");
        changed.draw_reactions(one, &arrows, &forces);
        declared.draw_reactions(other, &arrows, &forces);
        let pixels = |frame: &[[u8; 160]; 120]| frame.as_flattened().to_vec();
        let pairs = pixels(one.pixels()).into_iter().zip(pixels(other.pixels()));
        // A corner that lies on the middle of a pixel may go either way by rounding.
        let differ = pairs.filter(|(one, other)| one != other).count();
        assert!(differ <= 2, "{differ} pixels differ");
        assert!(one.pixels().as_flattened().iter().any(|&pixel| pixel != 0));
    }
}

/// A slider-crank that follows a law whose numbers are params, or constants.
macro_rules! lawful {
    ($name:ident: $scalar:ident, $word:ident $swing:tt $pace:tt $length:tt) => {
        mechanism! {
            struct $name: $scalar;
            $word swing = $swing;
            $word pace = $pace;
            $word length = $length;
            const DOUBLE = 2 * pace;
            ground { point o = (0, 0); line track = (0, 0.25) -> (1, 0); }
            link crank { point o = (0, 0); point pin = (1, 0); }
            link rod { point pin = (0, 0); point end = (length, 0); }
            link block { point end = (0, 0); line track = (0, 0) -> (1, 0); }
            joint a = revolute(ground.o, crank.o);
            joint b = revolute(crank.pin, rod.pin);
            joint c = revolute(rod.end, block.end);
            joint x = prismatic(ground.track, block.track);
            motor a = swing * sin(DOUBLE * t) + hypot(t, pace) - pace;
            start { rod near 0; }
            effects { velocity; acceleration; }
        }
    };
}

lawful!(Lawful: f64, param 0.3 1.0 4);
lawful!(Fixed: f64, const 0.5 1.5 3.5);
lawful!(Single: f32, param 0.3 1.0 4);

#[test]
fn laws_go_with_the_params_in_them() {
    let (mut changed, mut fixed, mut single) = (Lawful::new(), Fixed::new(), Single::new());
    changed.set_params([0.5, 1.5, 3.5]).expect("it closes");
    single.set_params([0.5, 1.5, 3.5]).expect("it closes");
    for step in 0..100 {
        let time = 0.07 * f64::from(step);
        changed.at_time(time).expect("a crank turns");
        fixed.at_time(time).expect("a crank turns");
        single.at_time(time).expect("a crank turns");
        let value = 0.5 * (3.0 * time).sin() + time.hypot(1.5) - 1.5;
        let rate = 1.5 * (3.0 * time).cos() + time / time.hypot(1.5);
        near(changed.a(), value, 1.0);
        near(changed.a_rate(), rate, 1.0);
        near(changed.x(), fixed.x(), 1.0);
        near(changed.x_rate(), fixed.x_rate(), 1.0);
        near(changed.x_acceleration(), fixed.x_acceleration(), 10.0);
        assert!((f64::from(single.x()) - fixed.x()).abs() < 1e-4);
    }
}

#[test]
fn cams_go_with_the_params_in_their_laws() {
    let mut lobed = Lobed::new();
    lobed.move_to([1.0]).expect("it is free");
    for (lift, pace) in [(0.3_f64, 1.0_f64), (4.0, 2.0), (0.01, 0.5)] {
        lobed.set_params([lift, pace]).expect("it has a value");
        for angle in [1.0_f64, -4.0, 9.0] {
            lobed.move_with([angle], [2.0]).expect("it is free");
            let (sin, cos) = (pace * angle).sin_cos();
            near(lobed.f(), lift.sqrt() * (1.0 - cos), 1.0);
            near(lobed.f_rate(), lift.sqrt() * 2.0 * pace * sin, 1.0);
            near(lobed.follower_tip().y, 1.0 + lobed.f(), 1.0);
            let [by_lift, by_pace] = lobed.f_sensitivity().expect("regular");
            near(by_lift, 0.5 / lift.sqrt() * (1.0 - cos), 1.0);
            near(by_pace, lift.sqrt() * angle * sin, 1.0);
        }
    }
    let before = lobed;
    assert!(lobed.set_lift(-1.0).is_err());
    assert_eq!(lobed, before);
}

#[test]
fn a_law_without_a_value_stops_the_move() {
    let mut lawful = Lawful::new();
    lawful.at_time(0.5).expect("a crank turns");
    let before = lawful;
    let blocked = lawful.at_time(f64::NAN).expect_err("no time");
    assert_eq!((blocked.cause, blocked.reached), (Cause::NotFinite, lawful.motors()));
    assert_eq!(lawful, before);
}

#[test]
fn every_function_goes_with_params() {
    let mut computed = Computed::new();
    for (p, q) in [(0.6_f64, 1.7_f64), (0.3, 2.2), (-0.9, 1.3), (0.99, 0.4)] {
        computed.set_params([p, q]).expect("it has a value");
        let expected = [
            [2.0 + p.asin() + (p / 2.0).acos(), p.atan2(q) + q.atan()],
            [p.hypot(q) - p.min(q) / 4.0 + (-p).exp(), (p - q).abs() + p.max(q * q)],
            [(3.0 * q).floor() + (p - q).signum(), 5.0 * q - p * (5.0 * q / p).floor()],
            [q.sqrt() - (p / 2.0).tan(), p.sin() * q.cos()],
        ];
        let found = [computed.a_b(), computed.a_c(), computed.a_d(), computed.a_e()];
        for (found, [x, y]) in found.into_iter().zip(expected) {
            assert!((found.x - x).hypot(found.y - y) < 1e-13, "{found:?} {x} {y}");
        }
        // By calculus.
        let root = (1.0 - p * p).sqrt();
        let of_b = [
            [1.0 / root - 0.5 / (1.0 - p * p / 4.0).sqrt(), q / (p * p + q * q)],
            [0.0, -p / (p * p + q * q) + 1.0 / (1.0 + q * q)],
        ];
        let slopes = computed.a_b_sensitivity().expect("regular");
        for (found, [x, y]) in slopes.into_iter().zip(of_b) {
            assert!((found.x - x).hypot(found.y - y) < 1e-12, "{found:?} {x} {y}");
        }
        // Whole numbers stay, and what is left of whole times grows with what it is a remainder of.
        let [by_p, by_q] = computed.a_d_sensitivity().expect("regular");
        assert!((by_p.x, by_q.x) == (0.0, 0.0), "{by_p:?} {by_q:?}");
        assert!((by_p.y + (5.0 * q / p).floor()).abs() < 1e-12 && (by_q.y - 5.0).abs() < 1e-12);
    }
}

#[test]
fn what_has_no_value_is_refused_and_changes_nothing() {
    let mut computed = Computed::new();
    computed.move_to([0.3, 0.2, 0.1]).expect("it is free");
    let before = computed;
    for params in [[1.5, 1.7], [-1.5, 1.7], [0.6, -0.1], [0.0, 1.7]] {
        let refused = computed.set_params(params);
        assert!(refused.is_err(), "{params:?}");
        assert_eq!(computed, before, "{params:?}");
    }
}
