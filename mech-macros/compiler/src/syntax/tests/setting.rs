//! The `struct` line, motors, the start, how loops are solved, and what is wanted and let pass.

use super::{good, parsed};
use crate::model::{AtChangePoints, Method, Model, Range, Target};
use crate::syntax::Parsed;

const CRANK: &str = "ground { point o = (0, 0); line l = (0, 0) -> (1, 0); } link crank { point p = (0, 0); } link wheel;\n\
    joint shaft = revolute(ground.o, crank.p); joint mesh = gear(crank, wheel, 1 : 2);\n\
    joint drawn = revolute(ground, wheel) at (3, 0);\n";

fn with_crank(text: &str) -> Parsed {
    good(&format!("struct M; {CRANK}{text}"))
}

#[test]
fn accelerations_bring_velocities_with_them() {
    use crate::model::Effects;
    let effects = |text| {
        let Effects { velocity, acceleration, .. } =
            good(&format!("struct M; {text}")).model.effects;
        [velocity, acceleration]
    };
    assert_eq!(effects(""), [false, false]);
    assert_eq!(effects("effects { velocity; }"), [true, false]);
    assert_eq!(effects("effects { acceleration; }"), [true, true]);
}

#[test]
fn some_things_are_let_pass() {
    use crate::model::Allowances;
    let allow = |text| {
        let Allowances { redundant, coupled } = good(&format!("struct M; {text}")).model.allow;
        [redundant, coupled]
    };
    assert_eq!(allow(""), [false, false]);
    assert_eq!(allow("allow redundant;"), [true, false]);
    assert_eq!(allow("allow coupled; allow redundant;"), [true, true]);
}

#[test]
fn what_is_shown_is_noted() {
    use crate::model::{AxisId, JointId, LinkId, Shown};
    let show = |text| with_crank(text).model.show;
    assert_eq!(show(""), None);
    let (crank, wheel) = (LinkId::new(1), LinkId::new(2));
    assert_eq!(
        show("show crank, drawn; motor shaft;"),
        Some(vec![Shown::Link(crank), Shown::Joint(JointId::new(2))])
    );
    // The third axis of the text, after the two of the ground.
    assert_eq!(
        show("show wheel, crank.p, shaft,; motor shaft;"),
        Some(vec![Shown::Link(wheel), Shown::Point(AxisId::new(2)), Shown::Joint(JointId::new(0))])
    );
}

#[test]
fn what_is_continuous_turns_and_is_shown() {
    use crate::model::JointId;
    let continuous = |text| with_crank(text).model.continuous;
    assert_eq!(continuous(""), []);
    assert_eq!(continuous("continuous shaft,;"), [JointId::new(0)]);
    assert_eq!(
        continuous("continuous drawn, shaft; show crank, shaft, drawn; motor shaft;"),
        [JointId::new(2), JointId::new(0)]
    );
}

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
        ("motor shaft in 0 deg ..= 90 deg;", (Some([0.0, quarter]), None)),
        ("motor shaft in 0deg..=90deg by 1deg;", (Some([0.0, quarter]), Some(1_f64.to_radians()))),
        ("motor shaft in -1..=1;", (Some([-1.0, 1.0]), None)),
        ("motor shaft by 0.5;", (None, Some(0.5))),
        // More than the range is as good as none.
        ("motor shaft in -1 ..= 1 by 7;", (Some([-1.0, 1.0]), Some(7.0))),
        ("const A = 2; motor shaft in -A ..= A + 1 by A / 4;", (Some([-2.0, 3.0]), Some(0.5))),
    ] {
        assert_eq!(only_motor(text), expected, "{text}");
    }
}

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
    assert_eq!(accuracy("const A = 1e-3; accuracy A / 10;"), Some(1e-3 / 10.0));
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
    assert_eq!(change_points("at change points go on;"), AtChangePoints::GoOn);
    assert_eq!(change_points("at change points keep branch;"), AtChangePoints::KeepBranch);
    assert_eq!(change_points("at change points stop;"), AtChangePoints::Stop);
}

#[test]
fn a_setting_after_a_missing_semicolon_is_read() {
    let text = "struct M; joint d = revolute(ground, a) at (0, 0)\nat change points stop; link a\naccuracy 1e-9;\n\
        const A = 1\ncost cortex_m4f; link b;";
    let model = parsed(text).model;
    assert_eq!(model.accuracy, Some(1e-9));
    assert_eq!(model.change_points, AtChangePoints::Stop);
    assert_eq!(model.target, Target::CortexM4f);
}

#[test]
fn the_struct_line_comes_first() {
    let missing = "expected `struct Name;` first; it names the type that the mechanism becomes";
    assert_eq!(parsed("").errors[0].text, missing);
    assert_eq!(parsed("struct M; struct N;").model.name, "M");
}
