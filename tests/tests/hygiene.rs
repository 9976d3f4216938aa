//! What a mechanism is made of meets whatever the user's crate has: other names for the same things, the same names for
//! other things, and every lint there is.

#[test]
fn the_runtime_may_have_another_name() {
    let mut machine = mech_renamed::Machine::new();
    machine.move_to([0.1, 0.2]).expect("it moves");
    assert!(machine.h() < 5.0);
}

/// Links, joints and points that are named as the expansion might name something.
mod inner_names {
    #![allow(non_snake_case, reason = "some are types or constants there")]

    mech_runtime::mechanism! {
        pub(crate) struct Motion;

        const step = 1.0;
        const x = 3.0;

        ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
        link last { point x = (0.0, 0.0); point y = (step, 0.0); }
        link position { point cos = (0.0, 0.0); point sin = (x, 0.0); }
        link step { point motors = (0.0, 0.0); point pose = (2.5, 0.0); }

        joint angle = revolute(ground.o, last.x);
        joint slide = revolute(last.y, position.cos);
        joint det = revolute(position.sin, step.pose);
        joint gap = revolute(ground.p, step.motors);

        motor angle;
        start { angle = 60 deg; position near 30 deg; }
    }

    mech_runtime::mechanism! {
        pub(crate) struct ThisMechanism: f32;

        link t;
        link laws;
        link ram_with;
        link hand { point wrist = (0.0, 0.0); }
        joint exp = revolute(ground, t) at (0.0, 0.0);
        joint rates = prismatic(t, laws) at (0.0, 0.0) along (1.0, 0.0);
        joint Some = revolute(ground, ram_with) at (0.0, 1.0);
        joint START = revolute(ram_with, hand) at (1.0, 1.0);
        motor exp = exp(t) - 1.0;
        motor rates = sin(t);
        motor Some;
        motor START;
        effects { velocity; }
    }
}

#[test]
fn links_and_joints_may_have_any_name() {
    let mut mechanism = inner_names::Motion::new();
    mechanism.move_to([1.1]).expect("it moves");
    assert!(mechanism.gap() > 0.0);
    let mut itself = inner_names::ThisMechanism::new();
    itself.at_time(0.1).expect("it moves");
    assert!(itself.rates_rate() > 0.9);
    assert_eq!(itself.START(), 0.0);
}

/// Every lint that is not about style of writing alone, and pedantic clippy beside those of the workspace.
pub mod strict {
    #![deny(
        missing_docs,
        missing_debug_implementations,
        missing_copy_implementations,
        unused,
        unused_qualifications,
        unused_results,
        unreachable_pub,
        nonstandard_style,
        trivial_casts,
        trivial_numeric_casts,
        elided_lifetimes_in_paths,
        single_use_lifetimes,
        let_underscore_drop,
        clippy::all,
        clippy::pedantic,
        clippy::nursery,
        clippy::std_instead_of_core,
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::missing_const_for_fn
    )]
    #![allow(
        clippy::suboptimal_flops,
        reason = "`mul_add` is slow where there is no instruction for it, and gives other digits where there is"
    )]

    mech_runtime::mechanism! {
        /// A four-bar.
        pub struct FourBar;

        ground { polygon [(-0.5, 0.0), (0.5, 0.0), (0.0, 0.5)]; }
        link crank;
        link coupler { point tip = (1.5, 3.0); circle (1.5, 3.0) radius 0.2; }
        link rocker;

        joint a = revolute(ground, crank) at (0.0, 0.0);
        joint b = revolute(crank, coupler) at (0.5, 0.8);
        joint c = revolute(coupler, rocker) at (3.0, 2.0);
        joint d = revolute(ground, rocker) at (3.5, 0.0);

        motor a;
    }

    mech_runtime::mechanism! {
        /// A four-bar in single precision, by a fixed number of steps.
        pub struct Small: f32;

        ground { polygon [(-0.5, 0.0), (0.5, 0.0), (0.0, 0.5)]; }
        link crank;
        link coupler { point tip = (1.5, 3.0); circle (1.5, 3.0) radius 0.2; }
        link rocker;

        joint a = revolute(ground, crank) at (0.0, 0.0);
        joint b = revolute(crank, coupler) at (0.5, 0.8);
        joint c = revolute(coupler, rocker) at (3.0, 2.0);
        joint d = revolute(ground, rocker) at (3.5, 0.0);

        motor a;
        method newton(2);
    }

    mech_runtime::mechanism! {
        /// A pair of gears, a piston, and an arm.
        pub struct Machine;

        ground {
            point o = (-3.0, 0.0);
            point p = (0.0, 0.0);
            line bore = (0.0, 0.0) -> (1.0, 0.0);
            polygon [(4.0, 0.6), (8.0, 0.6), (8.0, 0.8)];
        }
        link pinion { point shaft = (0.0, 0.0); circle (0.0, 0.0) radius 1.0; }
        link wheel { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
        link rod { point big_end = (0.0, 0.0); point small_end = (4.0, 0.0); }
        link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (1.0, 0.0); }
        link hand { point wrist = (0.0, 0.0); }

        joint d = revolute(ground.o, pinion.shaft);
        joint e = revolute(ground.p, wheel.shaft);
        joint mesh = gear(pinion, wheel, 20 : 40);
        joint f = revolute(wheel.pin, rod.big_end);
        joint g = revolute(rod.small_end, piston.pin);
        joint h = prismatic(ground.bore, piston.axis);
        joint wrist = revolute(piston.pin, hand.wrist);

        motor d;
        motor wrist;
        start { rod near 0 deg; }
    }

    mech_runtime::mechanism! {
        /// A slider alone.
        pub struct Slider;

        link piston;
        joint a = prismatic(ground, piston) at (0.0, 0.0) along (1.0, 0.0);
        motor a;
    }

    mech_runtime::mechanism! {
        /// Motors that follow laws, in single precision.
        pub struct Timed: f32;

        link arm;
        link hand;
        joint a = revolute(ground, arm) at (0.0, 0.0);
        joint b = revolute(arm, hand) at (1.0, 0.0);
        motor a = 3.0 * t;
        motor b = exp(-t) * sin(2.0 * t) + max(0.0, t - 1.0);
        effects { velocity; acceleration; }
    }

    mech_runtime::mechanism! {
        /// A cam, with everything that a law may be made of.
        pub struct Lifter;

        link disk;
        link valve;
        joint a = revolute(ground, disk) at (0.0, 0.0);
        joint h = prismatic(ground, valve) at (0.0, 1.0) along (0.0, 1.0);
        joint c = cam(a, h, exp(sin(q)) - 1.0 + max(0.0, atan(q) / (1.0 + abs(q))) + sqrt(4.0) - 2.0);
        motor a;
        effects { velocity; acceleration; }
    }

    mech_runtime::mechanism! {
        /// A law that does not depend on the time, in double precision.
        pub struct Still;

        link arm;
        link hand;
        joint a = revolute(ground, arm) at (0.0, 0.0);
        joint b = revolute(arm, hand) at (1.0, 0.0);
        motor a = 0.0;
        motor b;
    }
}

#[test]
fn lints_find_nothing() {
    assert_eq!(strict::FourBar::new(), strict::FourBar::default());
    assert_eq!(strict::Small::new(), strict::Small::default());
    assert_eq!(strict::Machine::new(), strict::Machine::default());
    assert_eq!(strict::Slider::new(), strict::Slider::default());
    assert!(strict::Timed::new().at_time(0.5).is_ok());
    assert!(strict::Lifter::new().move_to([0.5]).is_ok());
    assert!(strict::Still::new().at_time(0.5).is_ok());
}
