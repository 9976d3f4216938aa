//! Positions of rest, against closed forms, and against energies that are computed from what was declared.

use mech_runtime::{Cause, Phase, Place, Real, mechanism};
use mech_test_support::{Dice, cases, seeds, valley};

type Vector = [f64; 2];

/// By how much an angle differs from another, whole turns aside.
fn apart(found: f64, expected: f64) -> f64 {
    let (sin, cos) = (found - expected).sin_cos();
    sin.atan2(cos).abs()
}

fn turned(angle: f64, [x, y]: Vector) -> Vector {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

fn angle([x, y]: Vector) -> f64 {
    y.atan2(x)
}

fn sum([x, y]: Vector, [u, v]: Vector) -> Vector {
    [x + u, y + v]
}

/// The potential energy of the four-bar below, whose coupler is so long.
fn four_bar_energy(length: f64, crank: f64) -> f64 {
    let pin = turned(crank, [1.0, 0.0]);
    let across = [4.0 - pin[0], -pin[1]];
    let square = across[0] * across[0] + across[1] * across[1];
    let cos = (length * length + square - 2.5 * 2.5) / (2.0 * length * square.sqrt());
    let coupler = angle(across) + cos.acos();
    let end = sum(pin, turned(coupler, [length, 0.0]));
    let rocker = angle([end[0] - 4.0, end[1]]);
    let heights = 5.0 * turned(crank, [0.1, 0.05])[1]
        + sum(pin, turned(coupler, [2.0, 0.3]))[1]
        + 0.5 * turned(rocker, [1.2, 0.0])[1];
    let twist = rocker - 110.0_f64.to_radians();
    9.81 * heights + 1.5 * twist * twist
}

/// Mechanisms and tests in a precision, to within so much.
macro_rules! at_rest {
    ($module:ident: $real:ident, $near:literal) => {
        mod $module {
            use super::*;

            fn real(number: f64) -> $real {
                Real::from_f64(number)
            }

            mechanism! {
                struct Bob: $real;
                ground { point o = (0, 0); }
                link bob { point o = (0, 0); mass 2 at (3, 1); }
                joint a = revolute(ground.o, bob.o);
                motor a;
                gravity (6, 8);
                load push = torque(bob);
                effects { force; }
            }

            mechanism! {
                struct Ranged: $real;
                ground { point o = (0, 0); }
                link bob { point o = (0, 0); mass 2 at (3, 1); }
                joint a = revolute(ground.o, bob.o);
                motor a in -60 deg ..= 40 deg;
                gravity (6, 8);
                load push = torque(bob);
                effects { force; }
            }

            mechanism! {
                struct Scale: $real;
                ground { line rail = (0, 0) -> (3, 4); point hook = (-3, -4); }
                link pan { line rail = (0, 0) -> (1, 0); point eye = (0, 0); mass 2; }
                joint x = prismatic(ground.rail, pan.rail);
                motor x;
                gravity (1, -9);
                spring s = linear(ground.hook, pan.eye) stiffness 40 rest 5.5;
                load push = force(pan.eye);
                effects { force; }
            }

            mechanism! {
                struct Sled: $real;
                ground { line rail = (0, 0) -> (3, 4); }
                link sled { line rail = (0, 0) -> (1, 0); point eye = (0, 0); }
                joint x = prismatic(ground.rail, sled.rail);
                motor x;
                load push = force(sled.eye);
                effects { force; }
            }

            mechanism! {
                struct Arms: $real;
                ground { point o = (0, 0); }
                link upper { point o = (0, 0); point elbow = (1.2, 0); mass 1.5 at (1.2, 0); }
                link fore { point elbow = (0, 0); point tip = (0.9, 0); mass 0.7 at (0.9, 0); }
                joint a = revolute(ground.o, upper.o);
                joint b = revolute(upper.elbow, fore.elbow);
                motor a;
                motor b;
                gravity (0, -9.81);
                load push = force(fore.tip);
                effects { force; dynamics; velocity; }
            }

            mechanism! {
                struct FourBar: $real;
                param length = 4;
                ground { point o = (0, 0); point p = (4, 0); }
                link crank { point shaft = (0, 0); point pin = (1, 0); mass 5 at (0.1, 0.05); }
                link coupler { point left = (0, 0); point right = (length, 0); mass 1 at (2, 0.3); }
                link rocker { point pin = (2.5, 0); point shaft = (0, 0); mass 0.5 at (1.2, 0); }
                joint a = revolute(ground.o, crank.shaft);
                joint b = revolute(crank.pin, coupler.left);
                joint c = revolute(coupler.right, rocker.pin);
                joint d = revolute(ground.p, rocker.shaft);
                motor a;
                start { coupler near 40 deg; }
                gravity (0, -9.81);
                spring soft = torsional(d) stiffness 3 rest 110 deg;
                effects { force; }
            }

            mechanism! {
                /// A parallelogram, pulled to where it lies flat: there is its change point.
                struct Flat: $real;
                ground { point o = (0, 0); point p = (3, 0); }
                link left { point o = (0, 0); point q = (1, 0); mass 1 at (1, 0); }
                link bar { point q = (0, 0); point r = (3, 0); }
                link right { point p = (0, 0); point r = (1, 0); mass 2 at (0.5, 0); }
                joint a = revolute(ground.o, left.o);
                joint b = revolute(left.q, bar.q);
                joint c = revolute(bar.r, right.r);
                joint d = revolute(ground.p, right.p);
                motor a;
                start { a = 80 deg; bar near 0 deg; }
                gravity (10, 0);
                effects { force; }
            }

            mechanism! {
                /// Driven by its slide: its dead point is at 2.5.
                struct Engine: $real;
                ground { point shaft = (0, 0); line bed = (0, 0) -> (1, 0); }
                link crank { point shaft = (0, 0); point pin = (0.5, 0); }
                link rod { point big = (0, 0); point small = (2, 0); }
                link piston { point pin = (0, 0); line axis = (0, 0) -> (1, 0); mass 2; }
                joint turn = revolute(ground.shaft, crank.shaft);
                joint big = revolute(crank.pin, rod.big);
                joint small = revolute(rod.small, piston.pin);
                joint bed = prismatic(ground.bed, piston.axis);
                motor bed;
                start { bed = 2; crank near 80 deg; }
                gravity (10, 0);
                effects { force; }
            }

            #[test]
            fn a_bob_hangs_along_gravity_unless_it_is_pushed() {
                let (down, arm) = (angle([6.0, 8.0]), angle([3.0, 1.0]));
                for seed in seeds(cases(20)) {
                    let mut dice = Dice::new(seed);
                    let push = dice.between(-50.0, 50.0);
                    let mut bob = Bob::new();
                    bob.move_to([real(dice.between(-7.0, 7.0))]).expect("it turns");
                    bob.set_push(real(push)).expect("finite");
                    assert_eq!(bob.come_to_rest([true]).expect("it rests"), [0.0]);
                    // 2 · 10 · √10 is the torque of the weight across gravity.
                    let expected = down - arm + (push / 20.0 / 10.0_f64.sqrt()).asin();
                    let error = apart(bob.motors()[0].to_f64(), expected);
                    assert!(error < $near, "seed {seed}: {error:e}");
                }
                // Where it stands upright, and after so many turns that their sum has lost its fraction.
                let mut bob = Bob::new();
                bob.move_to([real(down - arm - std::f64::consts::PI)]).expect("it turns");
                assert_eq!(bob.come_to_rest([true]).expect("it rests"), [0.0]);
                assert!(apart(bob.motors()[0].to_f64(), down - arm) < $near);
                bob.turn_to([Phase::new(200_000_000, 1 << 62)]).expect("it turns");
                bob.come_to_rest([true]).expect("it rests");
                let found = bob.bob().rotation;
                assert!(apart(angle([found.re.to_f64(), found.im.to_f64()]), down - arm) < $near);
            }

            #[test]
            fn a_bob_leans_against_the_ends_of_its_range() {
                let free = angle([6.0, 8.0]) - angle([3.0, 1.0]);
                let [low, high] = [-60.0_f64, 40.0].map(f64::to_radians);
                for (push, end) in [(0.0, free), (-1000.0, low), (1000.0, high)] {
                    let mut bob = Ranged::new();
                    bob.set_push(real(push)).expect("finite");
                    let [torque] = bob.come_to_rest([true]).expect("it rests");
                    assert!(apart(bob.motors()[0].to_f64(), end) < $near);
                    let [x, y] = turned(end, [3.0, 1.0]);
                    let expected =
                        if end == free { 0.0 } else { -push - 2.0 * (x * 8.0 - y * 6.0) };
                    assert!(
                        (torque.to_f64() - expected).abs() <= $near * expected.abs(),
                        "{torque}"
                    );
                }
            }

            #[test]
            fn a_scale_tells_the_weight_along_its_rail() {
                for push in [[0.0, 0.0], [3.0, -20.0], [-50.0, 100.0]] {
                    let mut scale = Scale::new();
                    scale.set_push(push.map(real)).expect("finite");
                    scale.come_to_rest([true]).expect("it rests");
                    let along = 0.6 * (2.0 + push[0]) + 0.8 * (push[1] - 18.0);
                    let error = scale.motors()[0].to_f64() - (0.5 + along / 40.0);
                    assert!(error.abs() < $near, "{push:?}: {error:e}");
                }
            }

            #[test]
            fn each_arm_hangs_along_what_it_carries() {
                for seed in seeds(cases(20)) {
                    let mut dice = Dice::new(seed);
                    let mut number = |most: f64| dice.between(-most, most);
                    let (push, start) = ([number(20.0), number(20.0)], [number(3.0), number(3.0)]);
                    let carried = sum(push, [0.0, -0.7 * 9.81]);
                    let whole = sum(carried, [0.0, -1.5 * 9.81]);
                    let mut arms = Arms::new();
                    arms.set_push(push.map(real)).expect("finite");
                    arms.set_rates([real(1.0); 2]).expect("finite");
                    arms.move_to(start.map(real)).expect("free");
                    assert_eq!(arms.come_to_rest([true; 2]).expect("it rests"), [0.0; 2]);
                    let [a, b] = arms.motors().map(Real::to_f64);
                    let errors = [apart(a, angle(whole)), apart(a + b, angle(carried))];
                    assert!(errors.iter().all(|error| *error < $near), "seed {seed}: {errors:?}");
                    // It stays there.
                    assert_eq!(arms.rates(), [0.0; 2]);
                    for _ in 0..10 {
                        arms.simulate(real(0.01), [0.0; 2]).expect("nothing moves");
                    }
                    let moved = arms.motors().map(Real::to_f64);
                    assert!(
                        apart(moved[0], a) < $near && apart(moved[1], b) < $near,
                        "seed {seed}"
                    );
                    // With the elbow held, both are one body, and the elbow needs the torque of what it carries.
                    arms.move_to(start.map(real)).expect("free");
                    let [idle, held] = arms.come_to_rest([true, false]).expect("it rests");
                    let elbow = arms.motors()[1].to_f64();
                    let [x, y] = turned(-elbow, carried).map(|part| 0.9 * part);
                    let expected = angle(sum(whole.map(|part| 1.2 * part), [x, y]));
                    let a = arms.motors()[0].to_f64();
                    assert!(apart(a, expected) < $near, "seed {seed}");
                    let [x, y] = turned(a + elbow, [0.9, 0.0]);
                    let error = held.to_f64() + x * carried[1] - y * carried[0];
                    assert!(idle == 0.0 && error.abs() < 30.0 * $near, "seed {seed}: {error:e}");
                }
            }

            #[test]
            fn a_four_bar_rests_in_the_valley_in_which_it_is() {
                for seed in seeds(cases(6)) {
                    let mut dice = Dice::new(seed);
                    let (length, start) = (dice.between(3.8, 4.2), dice.between(-3.0, 3.0));
                    let mut four_bar = FourBar::new();
                    four_bar.set_params([real(length)]).expect("it closes");
                    four_bar.move_to([real(start)]).expect("it turns");
                    assert_eq!(four_bar.come_to_rest([true]).expect("it rests"), [0.0]);
                    let energy = |at| four_bar_energy(length, at);
                    let here = valley(energy, start);
                    let found = four_bar.motors()[0].to_f64();
                    let slope = (energy(found + 1e-5) - energy(found - 1e-5)) / 2e-5;
                    assert!((found - here).abs() < 2e-4, "seed {seed}: {found}, {here}");
                    assert!(slope.abs() < 100.0 * $near, "seed {seed}: {slope:e}");
                }
            }

            #[test]
            fn a_parallelogram_rests_at_its_change_point() {
                for start in [-2.5, -0.5, 0.01, 1.0, 3.0] {
                    let mut flat = Flat::new();
                    flat.move_to([real(start)]).expect("it turns");
                    assert_eq!(flat.come_to_rest([true]).expect("it rests"), [0.0]);
                    let errors = [flat.a(), flat.d()].map(|found| apart(found.to_f64(), 0.0));
                    assert!(errors.iter().all(|error| *error < $near), "{start}: {errors:?}");
                }
            }

            #[test]
            fn what_does_not_come_to_rest_stays_where_it_is_and_says_why() {
                let mut bob = Bob::new();
                bob.set_push(real(1000.0)).expect("finite");
                assert!(bob.set_push(real(f64::NAN)).is_err());
                let mut sled = Sled::new();
                let mut pushed = sled;
                pushed.set_push([real(-1.0), real(0.5)]).expect("finite");
                let mut engine = Engine::new();
                macro_rules! told {
                    ($m:ident, $is_free:literal) => {{
                        let before = $m;
                        let blocked = $m.come_to_rest([$is_free]).expect_err("it does not rest");
                        assert_eq!($m, before);
                        (blocked.cause, blocked.at())
                    }};
                }
                let ring = "`turn`, `big`, `small`";
                assert_eq!(told!(bob, true), (Cause::Restless, Place::Motor("a")));
                assert_eq!(told!(bob, false), (Cause::Unloaded, Place::Everywhere));
                assert_eq!(told!(sled, true), (Cause::Unloaded, Place::Everywhere));
                assert_eq!(told!(pushed, true), (Cause::Restless, Place::Motor("x")));
                assert_eq!(told!(engine, true), (Cause::Singular, Place::Loop(ring)));
            }
        }
    };
}

at_rest!(double: f64, 1e-9);
at_rest!(single: f32, 1e-4);

/// A four-bar of this size, as it is or upside down, with its gravity.
macro_rules! four_bar {
    ($name:ident: $real:ident, $size:literal, $up:literal) => {
        mechanism! {
            struct $name: $real;
            const S = $size; const U = $up;
            ground { point o = (0, 0); point p = (4 * S, 0); }
            link crank { point shaft = (0, 0); point pin = (S, 0); mass 5 at (0.1 * S, 0.05 * S * U); }
            link coupler { point left = (0, 0); point right = (4 * S, 0); mass 1 at (2 * S, 0.3 * S * U); }
            link rocker { point pin = (2.5 * S, 0); point shaft = (0, 0); mass 0.5 at (1.2 * S, 0); }
            joint a = revolute(ground.o, crank.shaft);
            joint b = revolute(crank.pin, coupler.left);
            joint c = revolute(coupler.right, rocker.pin);
            joint d = revolute(ground.p, rocker.shaft);
            motor a;
            start { coupler near 40 deg * U; }
            gravity (3, -9 * U);
            effects { force; }
        }
    };
}

four_bar!(Plain: f64, 1.0, 1.0);
four_bar!(Mirrored: f64, 1.0, -1.0);
four_bar!(Small: f64, 1e-3, 1.0);
four_bar!(Large: f32, 1e3, 1.0);

#[test]
fn what_is_mirrored_or_scaled_rests_likewise() {
    for start in [-2.5, -1.0, 0.5, 2.0] {
        let mut plain = Plain::new();
        plain.move_to([start]).expect("it turns");
        plain.come_to_rest([true]).expect("it rests");
        let [expected] = plain.motors();
        macro_rules! like {
            ($name:ident, $start:expr, $expected:expr, $near:literal) => {{
                let mut other = $name::new();
                other.move_to([Real::from_f64($start)]).expect("it turns");
                other.come_to_rest([true]).expect("it rests");
                let found = other.motors()[0].to_f64();
                assert!((found - $expected).abs() < $near, "{found}");
            }};
        }
        like!(Mirrored, -start, -expected, 1e-9);
        like!(Small, start, expected, 1e-9);
        like!(Large, start, expected, 1e-4);
    }
}
