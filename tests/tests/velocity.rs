//! Velocities and accelerations of generated code, against numbers nobody here made: the tables of `PMKS_Verification` and the
//! literature on Andrews' squeezer.

use super::literature::{Andrews, FourBar, SliderCrank, Tracer, rows};
use mech_runtime::{Cause, Velocity};
use mech_test_support::differences;
use std::f64::consts::TAU;

include!(concat!(env!("OUT_DIR"), "/velocity.rs"));

#[track_caller]
fn near(found: f64, expected: f64, scale: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(
        off <= tolerance * scale,
        "{found:?} instead of {expected:?}: off by {:e} of {scale}",
        off / scale
    );
}

/// Every number within 1e-10.
#[track_caller]
fn all_near<const N: usize>(found: impl IntoIterator<Item = f64>, expected: [f64; N]) {
    for (found, expected) in found.into_iter().zip(expected) {
        near(found, expected, 1.0, 1e-10);
    }
}

#[test]
fn a_four_bar_has_the_rates_that_three_programs_agree_on() {
    const RATE: f64 = 1.079_660_675_283_692_1;
    let mut four_bar = FourBar::new();
    for [degrees, expected @ ..] in rows::<9>(include_str!("literature/four-bar-rates.txt")) {
        let turn = f64::to_radians(degrees);
        four_bar.move_with([turn], [RATE], [0.0]).expect("it turns");
        let (v, a) = (four_bar.coupler_end_velocity(), four_bar.coupler_end_acceleration());
        let turns = [
            four_bar.coupler_velocity().angular,
            four_bar.coupler_acceleration().angular,
            four_bar.rocker_velocity().angular,
            four_bar.rocker_acceleration().angular,
        ];
        all_near([v[0], v[1], a[0], a[1]].into_iter().chain(turns), expected);
        let [.., coupler, _, rocker, _] = expected;
        near(four_bar.d_rate(), rocker, 1.0, 1e-10);
        near(four_bar.c_rate(), rocker - coupler, 1.0, 1e-10);
        near(four_bar.a_rate(), RATE, 1.0, 1e-15);
        let [influence] = four_bar.influence_coefficients().expect("it is regular");
        near(influence[1].angular * RATE, coupler, 1.0, 1e-10);
    }
}

#[test]
fn slider_cranks_have_the_rates_that_three_programs_agree_on() {
    let mut slider = SliderCrank::new();
    for [degrees, velocity, acceleration, rod @ ..] in
        rows::<5>(include_str!("literature/slider-crank-rates.txt"))
    {
        slider
            .move_with([degrees.to_radians()], [1.581_268_302_306_862_5], [0.0])
            .expect("it turns");
        let (v, a) = (slider.rod_end_velocity(), slider.rod_end_acceleration());
        all_near([v[0], v[1]], [velocity, 0.0]);
        all_near([a[0], a[1]], [acceleration, 0.0]);
        all_near([slider.x_rate(), slider.x_acceleration()], [velocity, acceleration]);
        let turns = (slider.rod_velocity(), slider.rod_acceleration());
        all_near([turns.0.angular, turns.1.angular], rod);
    }
    let mut tracer = Tracer::new();
    for [degrees, expected @ ..] in rows::<5>(include_str!("literature/tracer-rates.txt")) {
        tracer
            .move_with([degrees.to_radians()], [1.047_197_551_196_597_6], [0.0])
            .expect("it turns");
        let found = [
            tracer.rod_end_velocity()[0],
            tracer.rod_end_acceleration()[0],
            tracer.rod_velocity().angular,
            tracer.rod_acceleration().angular,
        ];
        all_near(found, expected);
    }
}

#[test]
fn andrews_squeezer_has_the_rates_of_the_literature() {
    let table = rows::<7>(include_str!("literature/andrews-rates.txt"));
    let [positions, rates, accelerations] = [table[0], table[1], table[2]];
    let mut andrews = Andrews::new();
    andrews.move_with([positions[0]], [rates[0]], [accelerations[0]]).expect("it turns");
    let found = [
        andrews.beta(),
        andrews.theta(),
        andrews.gamma(),
        andrews.phi(),
        andrews.delta(),
        andrews.omega(),
        andrews.epsilon(),
    ];
    for (found, expected) in found.into_iter().zip(positions) {
        let turns = ((found - expected) / TAU).round();
        near(found - turns * TAU, expected, 1.0, 1e-12);
    }
    let found = [
        andrews.beta_rate(),
        andrews.theta_rate(),
        andrews.gamma_rate(),
        andrews.phi_rate(),
        andrews.delta_rate(),
        andrews.omega_rate(),
        andrews.epsilon_rate(),
    ];
    for (found, expected) in found.into_iter().zip(rates) {
        near(found, expected, expected.abs(), 1e-7);
    }
    let found = [
        andrews.beta_acceleration(),
        andrews.theta_acceleration(),
        andrews.gamma_acceleration(),
        andrews.phi_acceleration(),
        andrews.delta_acceleration(),
        andrews.omega_acceleration(),
        andrews.epsilon_acceleration(),
    ];
    for (found, expected) in found.into_iter().zip(accelerations) {
        near(found, expected, expected.abs(), 1e-5);
    }
}

#[test]
fn after_a_move_without_rates_it_rests() {
    let mut four_bar = FourBar::new();
    four_bar.move_with([0.3], [2.0], [1.0]).expect("it turns");
    assert_ne!(four_bar.velocities()[0], Velocity::ZERO);
    four_bar.move_to([0.3]).expect("it is there");
    assert_eq!(*four_bar.velocities(), [Velocity::ZERO; 3]);
    four_bar.move_with([0.3], [2.0], [1.0]).expect("it turns");
    four_bar.turn_to([mech_runtime::Phase::from_turns(0.1).expect("a tenth")]).expect("it turns");
    assert_eq!(*four_bar.velocities(), [Velocity::ZERO; 3]);
}

#[test]
fn bad_rates_are_refused_and_leave_it_as_it_was() {
    let mut four_bar = FourBar::new();
    four_bar.move_with([0.3], [2.0], [1.0]).expect("it turns");
    let before = four_bar;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for refused in [
            four_bar.move_with([bad], [1.0], [0.0]),
            four_bar.move_with([0.4], [bad], [0.0]),
            four_bar.move_with([0.4], [1.0], [bad]),
        ] {
            assert_eq!(refused.expect_err("it is not finite").cause, Cause::NotFinite);
            assert_eq!(four_bar, before);
        }
    }
    let overflown = four_bar.move_with([0.4], [1e308], [0.0]);
    assert_eq!(overflown.expect_err("its square overflows").cause, Cause::Overflow);
    assert_eq!(four_bar, before);
}

#[test]
fn at_a_dead_point_rates_are_an_error_and_not_a_large_number() {
    let mut rocker = Rocker::new();
    let _ = rocker.move_toward([3.0]).expect("finite");
    let limit = rocker.motors();
    let before = rocker;
    let singular = rocker.move_with(limit, [1.0]).expect_err("it is at its dead point");
    assert_eq!(singular.cause, Cause::Singular);
    assert_eq!(singular.place, "`jb`, `jc`, `jd`");
    assert_eq!(singular.reached, limit);
    assert_eq!(rocker, before);
    assert_eq!(rocker.influence_coefficients().expect_err("there too").cause, Cause::Singular);
    // A thousandth before it they are determined, and large.
    rocker.move_with([limit[0] - 1e-3], [1.0]).expect("before the dead point");
    assert!(rocker.rocker_velocity().angular.abs() > 10.0);
}

#[test]
fn a_slots_coordinate_has_the_rates_of_its_differences() {
    let mut slotted = Slotted::new();
    let at = |time: f64| 0.7 + 1.3 * time + 0.5 * 0.4 * time * time;
    let mut slide = |time: f64| {
        slotted.move_to([at(time)]).expect("it turns");
        slotted.s()
    };
    let step = 1e-3;
    let slides = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|index| slide(index * step));
    let [rate, acceleration] = differences(slides, step);
    slotted.move_with([0.7], [1.3], [0.4]).expect("it turns");
    near(slotted.s_rate(), rate, 1.0, 1e-10);
    near(slotted.s_acceleration(), acceleration, 1.0, 1e-7);
}
