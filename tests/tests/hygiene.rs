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

    include!(concat!(env!("OUT_DIR"), "/hygiene.rs"));
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
