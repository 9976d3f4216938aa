//! What is reported of a move that does not succeed: names, units and where.

use mech_runtime::{Blocked, BlockedOf, Cause, Mechanism, Place, Reached};
use std::f64::consts::PI;

include!(concat!(env!("OUT_DIR"), "/blocked.rs"));

/// The crank's pin is as far aside as the rod is long.
fn limit(rod: f64) -> f64 {
    (rod / 3.0).asin()
}

#[test]
fn the_values_reached_are_reported_with_names_and_units() {
    let mut short = Short::new();
    let blocked: BlockedOf<Short> = short.move_to([PI / 2.0, 0.0]).expect_err("it is too short");
    assert_eq!(blocked.cause, Cause::Open);
    assert_eq!(blocked.at(), Place::Loop(blocked.place));
    let [turn, lift] = blocked.reached;
    assert!((turn - limit(2.0)).abs() < 1e-9, "{turn}");
    let degrees = (turn.to_degrees() * 1000.0).round() / 1000.0;
    let expected = format!("turn = {turn:?} rad ({degrees:?}°), lift = {lift:?}");
    let text = blocked.to_string();
    assert!(text.ends_with(&expected), "{text}, not {expected}");
    assert!(text.contains("`big`"), "{text}");
    // The same in whatever form the values are.
    let listed = blocked.map(|values| values.to_vec());
    assert_eq!(listed.to_string(), text);
}

#[test]
fn a_limit_is_reported_as_an_error_is() {
    let mut short = Short::new();
    match short.move_toward([PI / 2.0, 1.0]) {
        Ok(Reached::Limit(blocked)) => {
            let expected = format!(", lift = {:?}", blocked.reached[1]);
            assert!(blocked.to_string().ends_with(&expected), "{blocked}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn params_are_reported_by_their_own_names() {
    let mut short = Short::new();
    let blocked: Blocked<f64> = short.set_rod(0.1).expect_err("it is too short");
    assert!((limit(blocked.reached) - 10_f64.to_radians()).abs() < 1e-9);
    let expected = format!("beyond rod = {:?}", blocked.reached);
    assert!(blocked.to_string().ends_with(&expected), "{blocked}");
    let blocked = short.set_params([0.1]).expect_err("it is too short");
    let expected = format!("beyond rod = {:?}", blocked.reached[0]);
    assert!(blocked.to_string().ends_with(&expected), "{blocked}");
    let blocked = short.set_rod(f64::NAN).expect_err("no number");
    assert_eq!(blocked.at(), Place::Param("rod"));
}

#[test]
fn motors_are_places() {
    let mut short = Short::new();
    let blocked = short.move_to([0.1, f64::NAN]).expect_err("no number");
    assert_eq!(blocked.at(), Place::Motor("lift"));
    let blocked = short.move_to([1e30, 0.0]).expect_err("too far");
    assert_ne!(blocked.at(), Place::Motor("turn"));
}

/// Any mechanism's error can be shown and boxed.
fn display<M: Mechanism>(blocked: Blocked<M::Motors>) -> String
where
    M::Motors: 'static,
{
    let boxed: Box<dyn std::error::Error> = Box::new(blocked);
    boxed.to_string()
}

#[test]
fn code_for_any_mechanism_prints_it() {
    let mut short = Short::new();
    let blocked = short.move_to([f64::NAN, 0.0]).expect_err("no number");
    assert_eq!(display::<Short>(blocked), "the value for `turn` is not a finite number");
}
