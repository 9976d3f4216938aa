//! Mechanisms that are moved by the time alone.

use mech_runtime::Cause;
use mech_test_support::mechanism_of;

include!(concat!(env!("OUT_DIR"), "/laws.rs"));

#[test]
fn the_time_gives_motors_the_values_of_their_laws() {
    let source = include_str!("../subjects/laws/four_bar.mech");
    let (_, compiled) = mechanism_of::<FourBar>(source);
    let timing = compiled.timing.expect("motors have laws");
    let (mut timed, mut given) = (FourBar::new(), FourBar::new());
    for step in 0..500 {
        let time = f64::from(step) * 0.01;
        let at = timing.at(time, &[]);
        let [values, rates, seconds] = [0, 1, 2].map(|part| [at[0][part], at[1][part]]);
        timed.at_time(time).expect("it moves");
        given.move_with(values, rates, seconds).expect("it moves");
        assert_eq!(timed, given);
    }
}

#[test]
fn without_effects_it_moves_as_if_it_were_given_the_values() {
    let (mut timed, mut given) = (Plain::new(), Plain::new());
    timed.move_to([0.0, 0.4]).expect("it moves");
    for step in 0..500 {
        let time = f64::from(step) * 0.01;
        timed.at_time(time).expect("it moves");
        given.move_to([1.5 * time, 0.4]).expect("it moves");
        assert_eq!(timed, given);
    }
}

#[test]
fn a_law_without_a_value_is_an_error_that_names_its_motor() {
    let mut ending = Ending::new();
    ending.at_time(0.5).expect("it moves");
    let there = ending;
    for (time, place) in [
        (1.5, "x"),
        // The root ends steeply: there is a value, and no rate.
        (1.0, "x"),
        (f64::NAN, "x"),
        (f64::INFINITY, "x"),
        (-1e308 * 10.0, "x"),
    ] {
        let blocked = ending.at_time(time).expect_err("there is no value");
        assert_eq!((blocked.place, blocked.cause), (place, Cause::NotFinite), "{time}");
        assert_eq!(blocked.reached, there.motors());
        assert_eq!(ending, there);
    }
    ending.at_time(-4.0).expect("it moves");
    assert_eq!(ending.x(), 5.0_f64.sqrt());
    let blocked = ending.at_time(3.0).expect_err("there is no value");
    assert_eq!(blocked.cause, Cause::NotFinite);
}

#[test]
fn single_precision_turns_exactly_for_hours() {
    let mut fast = Fast::new();
    for hour in 1..10 {
        let time = 3600.0 * f64::from(hour) + 0.003;
        fast.at_time(time).expect("it moves");
        let turns = 50.0 * time;
        let angle = std::f64::consts::TAU * (turns - turns.floor());
        let off = f64::from(fast.wheel().rotation.angle()) - angle;
        let off =
            (off + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI;
        assert!(off.abs() < 1e-6, "{off}");
        // The gear has half the turns, and knows which half.
        let half = -std::f64::consts::TAU * (0.5 * turns - (0.5 * turns).floor());
        let off = f64::from(fast.other().rotation.angle()) - half;
        let off =
            (off + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI;
        assert!(off.abs() < 1e-6, "{off}");
        assert_eq!(fast.w_rate(), 314.159_27);
    }
    let blocked = fast.at_time(1e300).expect_err("it is too far");
    assert_eq!((blocked.place, blocked.cause), ("w", Cause::Overflow));
}

#[test]
fn a_law_does_not_lead_out_of_a_range() {
    let mut ranged = Ranged::new();
    ranged.at_time(0.5).expect("it is within its range");
    let blocked = ranged.at_time(1.0).expect_err("it is outside");
    assert_eq!((blocked.place, blocked.cause), ("w", Cause::OutOfRange));
    assert_eq!(blocked.reached, [1.0]);
    assert_eq!(ranged.w(), 2.0 * 0.5_f64.sin());
}

#[test]
fn a_constant_is_a_law_too() {
    let mut still = Still::new();
    assert_eq!(still.w(), 0.25);
    still.move_to([1.0]).expect("it moves");
    still.at_time(7.0).expect("it moves");
    assert_eq!(still.w(), 0.25);
    assert!(still.at_time(f64::NAN).is_err());
}
