//! Motors, their ranges and steps.

use super::assert_messages;
use super::setting::with_crank;
use crate::model::Range;

#[test]
fn a_motor_drives_a_joint_that_can_be_driven() {
    with_crank(
        "motor «shft»;",
        &["unknown joint `shft`; did you mean `shaft`?"],
    );
    with_crank(
        "motor «crank»;",
        &["`crank` is a link; name one of its joints: `shaft`"],
    );
    with_crank(
        "motor «mesh»;",
        &["`mesh` is a gear, which carries no motor; put it on `shaft`, the revolute of `crank`"],
    );
    with_crank(
        "motor shaft; motor «shaft»;",
        &["joint `shaft` has a motor already; remove one of the two"],
    );
    with_crank(
        "joint run = belt(crank, wheel, 1 : 2); motor «run»;",
        &["`run` is a belt, which carries no motor; put it on `shaft`, the revolute of `crank`"],
    );
    with_crank(
        "joint fix = weld(crank, wheel); motor «fix»;",
        &[
            "`fix` is a weld, which does not move; make it a `revolute`, or put the motor on another joint",
        ],
    );
    with_crank("motor «;»", &["expected the name of a joint, found `;`"]);
}

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
fn a_range_is_written_in_order() {
    with_crank("motor shaft in 0 «.». 1;", &["expected `..=`, found `.`"]);
    with_crank("motor shaft in «.».= 1;", &["expected a number, found `.`"]);
    with_crank(
        "motor shaft in 0 ..= «;»",
        &["expected a number, found `;`"],
    );
    with_crank(
        "motor shaft in 0 ..= 1 by «;»",
        &["expected a number, found `;`"],
    );
    with_crank(
        "motor shaft by 1 deg «in» 0 ..= 1;",
        &["`in` stands before `by`; swap the two"],
    );
    with_crank(
        "motor shaft in 0 ..= 1 by 1 «by» 2;",
        &["expected `;`, found `by`"],
    );
}

#[test]
fn a_range_goes_up() {
    with_crank(
        "motor shaft in «90 deg ..= 0 deg»;",
        &["the range of motor `shaft` ends before it begins; write `0 deg ..= 90 deg`"],
    );
    // A start is not held against a range that is wrong itself.
    with_crank(
        "motor shaft in «3 ..= 1» by 1; start { shaft = 2; }",
        &["the range of motor `shaft` ends before it begins; write `1 ..= 3`"],
    );
    for one in ["0 ..= 0", "2 * 3 ..= 6", "0 ..= -0"] {
        with_crank(
            &format!("motor shaft in «{one}»;"),
            &[
                "motor `shaft` cannot move in a range of one value; give the range another end, or leave it out",
            ],
        );
    }
}

#[test]
fn the_numbers_of_a_motor_are_finite() {
    let large = "this number is too large; the largest is about 1.8e308";
    with_crank(
        "motor shaft in -«1e999» ..= «1 / 0» by «sqrt(-1)»;",
        &[
            large,
            "division by zero",
            "-1 has no square root; it is negative",
        ],
    );
    with_crank("motor shaft in 0 ..= «1e308 * 10»;", &[large]);
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
fn range_and_step_are_looked_at_whatever_the_joint() {
    with_crank(
        "motor «shft» in «1 ..= 0» by «0»;",
        &[
            "unknown joint `shft`; did you mean `shaft`?",
            "the range of motor `shft` ends before it begins; write `0 ..= 1`",
            "the step of motor `shft` must be greater than zero, not `0`",
        ],
    );
    with_crank(
        "motor shaft in 0 ..= 1; motor «shaft» in 5 ..= 6;",
        &["joint `shaft` has a motor already; remove one of the two"],
    );
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

#[test]
fn a_motor_that_is_not_listed_starts_at_zero() {
    let outside = "motor `shaft` starts at 0, outside its range, as `start` says nothing else; write \
                   `shaft = ...;` in `start` with a value within `1 ..= 2`, or widen it";
    with_crank("motor shaft in «1 ..= 2»;", &[outside]);
    with_crank(
        "start { crank near 0; } motor shaft in «1 ..= 2» by 1;",
        &[outside],
    );
    // It may have been meant to be listed.
    with_crank(
        "motor shaft in 1 ..= 2; start { «shft» = 1; }",
        &["unknown joint `shft`; did you mean `shaft`?"],
    );
    with_crank(
        "motor shaft in 1 ..= 2; start { shaft «1»; }",
        &["expected `=` (for a joint) or `near` (for a link), found `1`"],
    );
    with_crank(
        "motor shaft in 1 ..= 2; start { shaft = «1 / 0»; }",
        &["division by zero"],
    );
}

#[test]
fn a_drawn_motor_starts_where_it_is_drawn() {
    let outside = "motor `drawn` starts at 0, where it is drawn, outside its range; widen `1 ..= 2` so that it holds 0";
    with_crank("motor drawn in «1 ..= 2»;", &[outside]);
    with_crank("motor drawn in 1 ..= 2; start { drawn = «0»; }", &[outside]);
    with_crank(
        "motor drawn in 1 ..= 2; start { drawn = «1»; }",
        &[
            "joint `drawn` is placed in the drawing, where its coordinate is 0; leave this out, or draw its links as they \
             are to start",
        ],
    );
}

#[test]
fn every_motor_is_held_to_its_own_range() {
    let slide = "ground { point o = (0, 0); line l = (0, 0) -> (1, 0); } link a { point p = (0, 0); }\n\
                 link b { line l = (0, 0) -> (1, 0); } joint turn = revolute(ground.o, a.p); joint push = prismatic(ground.l, b.l);\n";
    assert_messages(
        &format!("{slide}motor push in «3 ..= 4»; motor turn in «1 ..= 2»;"),
        &[
            "motor `push` starts at 0, outside its range, as `start` says nothing else; write `push = ...;` in \
             `start` with a value within `3 ..= 4`, or widen it",
            "motor `turn` starts at 0, outside its range, as `start` says nothing else; write `turn = ...;` in \
             `start` with a value within `1 ..= 2`, or widen it",
        ],
    );
    assert_messages(
        &format!(
            "{slide}motor push in 3 ..= 4; motor turn in 1 ..= 2; start {{ turn = «3.5»; push = 3.5; }}"
        ),
        &[
            "motor `turn` starts at `3.5`, outside its range; choose a start within `1 ..= 2`, or widen the range",
        ],
    );
}
