//! The settings of how loops are solved: method, accuracy, cost and change points.

use super::good;
use crate::model::{AtChangePoints, Method, Model, Target};

fn settings(text: &str) -> Model {
    good(&format!("struct M; {text}")).model
}

#[test]
fn a_method_is_exact_newton_or_linear() {
    for (text, expected) in [
        ("", None),
        ("method exact;", Some(Method::Exact)),
        ("method linear;", Some(Method::Linear)),
        ("method newton;", Some(Method::Newton)),
        ("method newton(1);", Some(Method::NewtonSteps(1))),
        ("method newton(64);", Some(Method::NewtonSteps(64))),
    ] {
        assert_eq!(settings(text).method, expected, "{text}");
    }
}

#[test]
fn an_accuracy_is_a_positive_length() {
    let accuracy = |text| settings(text).accuracy;
    assert_eq!(accuracy(""), None);
    assert_eq!(accuracy("accuracy 1e-9;"), Some(1e-9));
    assert_eq!(
        accuracy("const A = 1e-3; accuracy A / 10;"),
        Some(1e-3 / 10.0)
    );
}

#[test]
fn costs_are_those_of_a_machine() {
    let target = |text| settings(text).target;
    assert_eq!(target(""), Target::X86_64);
    assert_eq!(target("cost x86_64;"), Target::X86_64);
    assert_eq!(target("cost cortex_m4f; accuracy 1e-3;"), Target::CortexM4f);
}

#[test]
fn change_points_are_passed_in_one_of_three_ways() {
    let change_points = |text| settings(text).change_points;
    assert_eq!(change_points(""), AtChangePoints::GoOn);
    assert_eq!(
        change_points("at change points go on;"),
        AtChangePoints::GoOn
    );
    assert_eq!(
        change_points("at change points keep branch;"),
        AtChangePoints::KeepBranch
    );
    assert_eq!(
        change_points("at change points stop;"),
        AtChangePoints::Stop
    );
}
