//! How the loops are solved.

use super::assert_messages;
use crate::model::{AtChangePoints, Method, Target};

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
        assert_eq!(assert_messages(text, &[]).model.method, expected, "{text}");
    }
    assert_messages(
        "method «newtn»(2);",
        &["unknown method `newtn`; did you mean `newton`?"],
    );
    assert_messages(
        "method «newtn»;",
        &["unknown method `newtn`; did you mean `newton`?"],
    );
    assert_messages(
        "method «exakt»;",
        &["unknown method `exakt`; did you mean `exact`?"],
    );
    assert_messages(
        "method «;»",
        &["expected `exact`, `newton` or `linear`, found `;`"],
    );
    assert_messages("method exact «2»;", &["expected `;`, found `2`"]);
    assert_messages(
        "method newton; «method» newton(2);",
        &["a mechanism has one `method`; remove one of the two"],
    );
}

#[test]
fn newton_takes_a_number_of_steps() {
    for (steps, shown) in [("0", "0"), ("2.5", "2.5"), ("65", "65"), ("-1", "-1")] {
        assert_messages(
            &format!("method newton(«{steps}»);"),
            &[&format!(
                "the number of newton steps is a whole number from 1 to 64, not {shown}"
            )],
        );
    }
    assert_messages("method newton(2«,» 3);", &["expected `)`, found `,`"]);
    assert_messages(
        "method newton«()»;",
        &["the number of newton steps is missing; write `newton(2)`, or leave the brackets out"],
    );
}

#[test]
fn other_methods_take_none() {
    assert_messages(
        "method exact«(2)»;",
        &["method `exact` takes no number of steps; leave the brackets out"],
    );
    assert_messages(
        "method linear«()»;",
        &["method `linear` takes no number of steps; leave the brackets out"],
    );
}

#[test]
fn an_accuracy_is_a_positive_length() {
    let accuracy = |text| assert_messages(text, &[]).model.accuracy;
    assert_eq!(accuracy(""), None);
    assert_eq!(accuracy("accuracy 1e-9;"), Some(1e-9));
    assert_eq!(
        accuracy("const A = 1e-3; accuracy A / 10;"),
        Some(1e-3 / 10.0)
    );
    assert_messages(
        "accuracy «0»;",
        &["an accuracy must be greater than zero, not 0"],
    );
    assert_messages(
        "accuracy «-1e-9»;",
        &["an accuracy must be greater than zero, not -1e-9"],
    );
    assert_messages(
        "accuracy «1e999»;",
        &["this number is too large; the largest is about 1.8e308"],
    );
    assert_messages("accuracy «;»", &["expected a number, found `;`"]);
    assert_messages(
        "accuracy 1e-9; «accuracy» 1e-6;",
        &["a mechanism has one `accuracy`; remove one of the two"],
    );
}

#[test]
fn an_accuracy_chooses_the_method() {
    let both =
        "`accuracy` chooses the method, so there cannot be both; remove `accuracy` or `method`";
    assert_messages("method newton; «accuracy» 1e-9;", &[both]);
    assert_messages("accuracy 1e-9; link a; «method» exact;", &[both]);
    assert_messages(
        "method newton; «accuracy» «0»; «method» exact; «accuracy» 1e-9;",
        &[
            both,
            "an accuracy must be greater than zero, not 0",
            "a mechanism has one `method`; remove one of the two",
            "a mechanism has one `accuracy`; remove one of the two",
        ],
    );
}

#[test]
fn costs_are_those_of_a_machine() {
    let target = |text| assert_messages(text, &[]).model.target;
    assert_eq!(target(""), Target::X86_64);
    assert_eq!(target("cost x86_64;"), Target::X86_64);
    assert_eq!(target("cost cortex_m4f; accuracy 1e-3;"), Target::CortexM4f);
    assert_messages(
        "cost «cortex_m4»;",
        &["unknown machine `cortex_m4`; did you mean `cortex_m4f`?"],
    );
    assert_messages(
        "cost «arm»;",
        &["unknown machine `arm`; there are `x86_64`, `cortex_m4f`"],
    );
    let what = "expected the name of a machine, `x86_64` or `cortex_m4f`, found";
    assert_messages("cost«;»", &[&format!("{what} `;`")]);
    assert_messages("cost «5»;", &[&format!("{what} `5`")]);
    assert_messages("cost cortex«-»m4f;", &["expected `;`, found `-`"]);
    assert_messages(
        "cost x86_64; «cost» x86_64;",
        &["a mechanism has one `cost`; remove one of the two"],
    );
}

#[test]
fn change_points_are_passed_in_one_of_three_ways() {
    let change_points = |text| assert_messages(text, &[]).model.change_points;
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
    assert_messages(
        "at change points stop; «at» change points go on;",
        &["a mechanism has one `at change points`; remove one of the two"],
    );
}

#[test]
fn the_first_wrong_word_about_change_points_is_reported() {
    for (marked, trouble) in [
        (
            "at change points «halt»;",
            "expected `go`, `keep` or `stop`, found `halt`",
        ),
        (
            "at change points«;»",
            "expected `go`, `keep` or `stop`, found `;`",
        ),
        (
            "at change points keep «going»;",
            "expected `branch`, found `going`",
        ),
        ("at change points go«;»", "expected `on`, found `;`"),
        (
            "at change «point» stop;",
            "expected `points`, found `point`",
        ),
        ("at «dead» points stop;", "expected `change`, found `dead`"),
        ("at «(»1, 2);", "expected `change`, found `(`"),
    ] {
        let choices = "write `at change points go on`, `at change points keep branch` or `at change points stop`";
        assert_messages(
            &format!("{marked} link a;"),
            &[&format!("{trouble}; {choices}")],
        );
    }
    assert_messages(
        "at change points stop «here»;",
        &["expected `;`, found `here`"],
    );
}
