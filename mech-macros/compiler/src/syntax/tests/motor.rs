//! Motors, their ranges and steps.

use super::setting::with_crank;
use crate::model::Range;

/// The ends of the only motor's range, and its step.
fn only_motor(text: &str) -> (Option<[f64; 2]>, Option<f64>) {
    let parsed = with_crank(text, &[]);
    let [motor] = parsed.model.motors.as_slice() else {
        panic!("one motor");
    };
    let ends = |Range { low, high, .. }| [low, high];
    (motor.range.map(ends), motor.step)
}

#[test]
fn a_motor_has_a_range_and_a_step() {
    let quarter = 90_f64.to_radians();
    for (text, expected) in [
        ("motor shaft;", (None, None)),
        (
            "motor shaft in 0 deg ..= 90 deg;",
            (Some([0.0, quarter]), None),
        ),
        (
            "motor shaft in 0deg..=90deg by 1deg;",
            (Some([0.0, quarter]), Some(1_f64.to_radians())),
        ),
        ("motor shaft in -1..=1;", (Some([-1.0, 1.0]), None)),
        ("motor shaft by 0.5;", (None, Some(0.5))),
        // More than the range is as good as none.
        (
            "motor shaft in -1 ..= 1 by 7;",
            (Some([-1.0, 1.0]), Some(7.0)),
        ),
        (
            "const A = 2; motor shaft in -A ..= A + 1 by A / 4;",
            (Some([-2.0, 3.0]), Some(0.5)),
        ),
    ] {
        assert_eq!(only_motor(text), expected, "{text}");
    }
}

#[test]
fn a_step_is_positive() {
    with_crank(
        "motor shaft by «0»;",
        &["the step of motor `shaft` must be greater than zero, not `0`"],
    );
    with_crank(
        "motor shaft in 0 ..= 1 by «-1 deg»;",
        &["the step of motor `shaft` must be greater than zero, not `-1 deg`"],
    );
    let parsed = with_crank(
        "motor shaft in «1 ..= 0» by «-1»;",
        &[
            "the range of motor `shaft` ends before it begins; write `0 ..= 1`",
            "the step of motor `shaft` must be greater than zero, not `-1`",
        ],
    );
    assert_eq!(parsed.model.motors.len(), 1);
}

#[test]
fn a_motor_starts_in_its_range() {
    for good in [
        "motor shaft in 0 ..= 1; start { shaft = 1; }",
        "motor shaft in 0 ..= 1; start { shaft = 0; }",
        "start { shaft = 6.2; } motor shaft in 6 ..= 6.25;",
        "motor shaft in -1 ..= 0;",
        // The same angle, computed in two ways that differ by a rounding.
        "motor shaft in PI / 7 ..= PI / 3; start { shaft = 60 deg; }",
        "motor shaft in 0 ..= 0.1 + 0.2; start { shaft = 0.3; }",
        "motor shaft in 0 ..= 0.3; start { shaft = 0.1 + 0.2; }",
        "motor drawn in -1 ..= 1; start { drawn = 0; }",
    ] {
        with_crank(good, &[]);
    }
    let outside = "motor `shaft` starts at `2`, outside its range; choose a start within `0 deg ..= 90 deg`, or widen the \
                   range";
    with_crank(
        "motor shaft in 0 deg ..= 90 deg; start { shaft = «2»; }",
        &[outside],
    );
    with_crank(
        "start { crank near 0; shaft = «2»; «spoke» = 0; } motor shaft in 0 deg ..= 90 deg; motor «spoke»;",
        &[
            outside,
            "unknown joint `spoke`; there are `shaft`, `mesh`, `drawn`",
            "unknown joint `spoke`; there are `shaft`, `mesh`, `drawn`",
        ],
    );
    with_crank(
        "motor shaft in 0 ..= 1; start { shaft = «-1e-9»; }",
        &[
            "motor `shaft` starts at `-1e-9`, outside its range; choose a start within `0 ..= 1`, or widen the range",
        ],
    );
}
