//! Laws of motors.

use super::good;
use crate::model::Law;

/// A mechanism whose motor follows a law, with something before it.
fn with_law(before: &str, law: &str) -> String {
    format!(
        "{before} ground {{ point o = (0, 0); }} link crank {{ point o = (0, 0); }}
        joint a = revolute(ground.o, crank.o); motor a = {law};"
    )
}

fn law(text: &str) -> Law {
    let text = format!("struct M; {}", with_law("const A = 3;", text));
    let model = good(&text).model;
    let law = model.motors[0].law.expect("the motor has a law");
    model.law(law).clone()
}

#[test]
fn laws_are_functions_of_the_time() {
    for (text, time, expected) in [
        ("t", 0.5, 0.5),
        ("7", 0.5, 7.0),
        ("A * t - t / A", 1.5, 4.0),
        ("2 * 3 * t / 2 / 3", 5.0, 5.0),
        ("-t", 2.0, -2.0),
        ("t deg", 180.0, std::f64::consts::PI),
        ("sqrt(t) + abs(-t)", 4.0, 6.0),
        ("sin(0 * t) + cos(0 * t) + tan(0 * t)", 1.0, 1.0),
        ("atan(t) + exp(t)", 0.0, 1.0),
        ("min(t, 2) - max(2, t)", 5.0, -3.0),
        ("min(t, t * t)", 0.5, 0.25),
        ("1 / (t - A + 4)", 3.0, 0.25),
        ("floor(t) + sign(-t) + mod(t, 2)", 3.5, 3.5),
        ("hypot(t, A) + atan2(t - 4, 1) + asin(t / 8 - 0.5)", 4.0, 5.0),
    ] {
        assert_eq!(law(text).at(time, &[]), expected, "{text}");
    }
}

#[test]
fn a_law_may_have_params_in_it() {
    let text = with_law("param p = 2; param q = 3; const SUM = p + q;", "SUM * t + p");
    let model = good(&format!("struct M; {text}")).model;
    let law = &model.laws[0];
    assert_eq!(law.at(2.0, &[2.0, 3.0]), 12.0);
    assert_eq!(law.at(2.0, &[10.0, 0.5]), 31.0);
    assert!(law.varies());
    assert_eq!(model.start.value(model.motors[0].joint), 2.0);
}

#[test]
fn a_law_is_kept_as_it_was_written() {
    assert_eq!(law("A*(t-1) deg").written, "A * (t - 1) deg");
    assert_eq!(law("max(0,-t)").written, "max(0, -t)");
}

#[test]
fn a_motor_starts_where_its_law_has_it() {
    let model = good(&format!("struct M; {}", with_law("", "cos(t) + t"))).model;
    let joint = model.motors[0].joint;
    assert_eq!(model.start.value(joint), 1.0);
    let text = format!("struct M; {} start {{ a = 90 deg; }}", with_law("", "PI / 2 + t"));
    assert_eq!(good(&text).model.start.values.len(), 1);
}

#[test]
fn what_is_drawn_starts_at_zero() {
    let text =
        "struct M; link crank; joint a = revolute(ground, crank) at (0, 0); motor a = sin(t + PI);";
    assert_eq!(good(text).model.start.values[0].value, 0.0);
}

#[test]
fn a_law_may_have_a_range_and_a_step() {
    let model = good(&format!("struct M; {}", with_law("", "sin(t) in -1 ..= 1 by 1 deg"))).model;
    assert!(model.motors[0].range.is_some() && model.motors[0].step.is_some());
}
