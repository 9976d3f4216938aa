//! Motors, their ranges and steps.

use super::setting::with_crank;
use crate::model::Range;

/// The ends of the only motor's range, and its step.
fn only_motor(text: &str) -> (Option<[f64; 2]>, Option<f64>) {
    let parsed = with_crank(text);
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
