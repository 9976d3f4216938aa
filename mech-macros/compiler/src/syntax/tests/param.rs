//! Params: what they are, where they may stand, and what is told where they may not.

use super::{assert_messages, good};
use crate::model::{Axis, Model, Now};

const ONLY: &str = "only laws, points, lines, joints in a drawing and shapes may depend on one; use a `const` here";

const POINT: &str = "the joints of a point count angles from its direction; only lines may turn; use a `const` here";

const ROLLING: &str = "what rolls keeps its ratio, so that it counts whole turns exactly (a `cam` may have a ratio in its law); use a `const` here";

fn refused(what: &str) -> String {
    refused_for(what, ONLY)
}

fn refused_for(what: &str, why: &str) -> String {
    format!("{what}: it may change while the mechanism runs; {why}")
}

fn axis<'m>(model: &'m Model, name: &str) -> &'m Axis {
    let mut axes = model.axes.iter();
    axes.find(|axis| axis.name.as_deref() == Some(name))
        .expect("it was declared")
}

#[test]
fn a_place_may_depend_on_params() {
    let text = "struct M; param length = 3 + 1; param angle = 30 deg; const HALF = length / 2; const FIXED = 2 * 3;
        link l { point a = (length, -HALF); point b = (FIXED, 1); point c = (cos(angle) * length, tan(angle) * 2); }";
    let model = good(text).model;
    let names: Vec<(&str, f64)> = model
        .params
        .all()
        .iter()
        .map(|param| (param.name.as_str(), param.value))
        .collect();
    assert_eq!(names, [("length", 4.0), ("angle", 30.0_f64.to_radians())]);
    assert_eq!(axis(&model, "a").at, [4.0, -2.0]);
    assert!(axis(&model, "a").formulas.iter().all(Option::is_some));
    assert!(!axis(&model, "b").varies());
    let (sin, cos) = (
        libm::sin(30.0_f64.to_radians()),
        libm::cos(30.0_f64.to_radians()),
    );
    assert_eq!(axis(&model, "c").at[0], cos * 4.0);
    assert!((axis(&model, "c").at[1] - 2.0 * sin / cos).abs() < 1e-15);
}

#[test]
fn joints_of_a_drawing_may_depend_on_params() {
    let text = "struct M; param x = 3; link a; link b;
        joint j = revolute(a, b) at (x, 0);
        joint k = prismatic(ground, b) at (x, 1) along (1, 0);";
    let model = good(text).model;
    assert_eq!(model.axes.iter().filter(|axis| axis.varies()).count(), 4);
    // Axes on one spot are one only as long as they stay there together.
    let text = "struct M; param x = 3; link a; link b; link c;
        joint j = revolute(a, b) at (x, 0); joint k = revolute(a, c) at (3, 0); joint l = revolute(a, c) at (x, 0);";
    assert_eq!(good(text).model.axes.len(), 5);
}

#[test]
fn a_direction_may_depend_on_params() {
    let text = "struct M; param p = 3; const Q = 2 * p; link a; link b;
        ground { line l = (0, 0) -> (p, 4); line m = (0, 0) -> p; line n = (0, 0) -> (3, 4); }
        joint k = prismatic(a, b) at (0, 1) along (4, 2 * Q);
        joint s = slot(b, a) at (0, 1) along Q;";
    let model = good(text).model;
    let [l, m, n] = ["l", "m", "n"].map(|name| axis(&model, name));
    assert_eq!(l.direction, [0.6, 0.8]);
    assert_eq!(m.direction, [libm::cos(3.0), libm::sin(3.0)]);
    assert!(l.turns() && m.turns() && !n.turns());
    // A slot's own line and the pin have none.
    assert_eq!(model.axes.iter().filter(|axis| axis.turns()).count(), 5);
    let now = |params: &[f64]| {
        let variable = f64::NAN;
        model.params.evaluate(&mut Now { variable, params })
    };
    let turned = |axis: &Axis, params: &[f64]| {
        axis.direction_formulas
            .map(|formula| now(params)[formula.expect("both").index()])
    };
    assert_eq!(turned(l, &[3.0]), [0.6, 0.8]);
    assert_eq!(turned(l, &[-3.0]), [-0.6, 0.8]);
    assert_eq!(turned(m, &[0.0]), [1.0, 0.0]);
}

#[test]
fn a_shape_may_depend_on_params() {
    let text = "struct M; param r = 3;
        link a { circle (r, 0) radius 2 * r; ring (0, 0) radius 2 hole 1; bar [(0, 0), (0, r)] width 1; }";
    let model = good(text).model;
    let shapes = &model.links[1].shapes;
    assert_eq!(shapes[0].kind.numbers(), [3.0, 0.0, 6.0]);
    let varies = |shape: usize| -> Vec<bool> {
        let formulas = shapes[shape].formulas.iter();
        formulas.map(Option::is_some).collect()
    };
    assert_eq!(varies(0), [true, false, true]);
    assert_eq!(varies(1), [false; 4]);
    assert_eq!(varies(2), [false, false, false, true, false]);
    assert_messages(
        "param r = -3; link a { circle (0, 0) radius «r»; ring (0, 0) radius -r hole «4»; }",
        &[
            "a radius must be greater than zero, not -3",
            "the hole of a ring is smaller than the ring, whose radius is 3",
        ],
    );
}

#[test]
fn equal_formulas_are_one() {
    let text = "struct M; param x = 3; link l { point a = (x * 2, 0); point b = (x * 2, 1); }";
    let model = good(text).model;
    assert_eq!(axis(&model, "a").formulas[0], axis(&model, "b").formulas[0]);
}

#[test]
fn everything_else_stays_as_it_is() {
    assert_messages(
        "param r = 1; const R = 2 * r;
        ground { point o = (0, 0) -> («r», 1); circle (0, 0) radius r on plane «r» color «r»; }
        link a { point o = (r, R) -> 0.5 * «R»; line l = (r, 0) -> (1, R); «density» 2; polygon [(0, 0), (R, 0), (0, 1)]; }
        joint j = revolute(ground.o, a.o);
        joint k = gear(ground, a, «r» : 2);
        motor j in 0 ..= «R» by «r»;
        start { j = «r»; a near 2 * «R»; }
        method newton(«r»);",
        &[
            &refused_for("`r` is a param", POINT),
            &refused("`r` is a param"),
            &refused("`r` is a param"),
            &refused_for("`R` is computed from a param", POINT),
            "the shapes of `a` depend on a param, but a mass may not; give its `mass`",
            &refused_for("`r` is a param", ROLLING),
            &refused("`R` is computed from a param"),
            &refused("`r` is a param"),
            &refused("`r` is a param"),
            &refused("`R` is computed from a param"),
            &refused("`r` is a param"),
        ],
    );
    assert_messages("param r = 1; accuracy «r»;", &[&refused("`r` is a param")]);
    assert_messages(
        "param a = 1; param b = «a» + 1;",
        &[&refused("`a` is a param")],
    );
}

#[test]
fn its_name_is_a_method() {
    assert_messages(
        "param crank = 1; link «crank»;",
        &["link `crank` and param `crank` would both be the method `crank`; rename one of them"],
    );
    assert_messages(
        "link crank; param «crank» = 1;",
        &["there is a link `crank` already; choose another name for this param"],
    );
    assert_messages(
        "param new_length = 1; param «poses» = 1;",
        &["`poses` is a method of every mechanism; choose another name for this param"],
    );
    assert_messages(
        "param length = 1; param «length» = 2; const «length» = 3;",
        &[
            "there is a param `length` already; choose another name for this param",
            "there is a param `length` already; choose another name for this constant",
        ],
    );
    assert_messages(
        "param length = 1; link «set_length»; link «params»;",
        &[
            "link `set_length` and changing param `length` would both be the method `set_length`; rename one of them",
            "link `params` and a mechanism with params would both be the method `params`; rename one of them",
        ],
    );
    assert_messages(
        "param «PI» = 3;",
        &["`PI` belongs to the language; choose another name"],
    );
}

#[test]
fn its_value_is_computed_where_it_stands() {
    assert_messages(
        "param a = «b»; param b = 1;",
        &["param `b` is declared further down; move its line up"],
    );
    assert_messages(
        "param a = 1 + «a»;",
        &["param `a` cannot be computed from itself"],
    );
    assert_messages(
        "param a = 1; link l { point p = («sqrt(-a)», «1 / (a - 1)»); }",
        &["-1 has no square root; it is negative", "division by zero"],
    );
}

#[test]
fn what_follows_no_param_has_no_sensitivity() {
    assert_messages(
        "effects { «sensitivity»; }",
        &[
            "`sensitivity` tells how everything follows the params, and there is none; write `param name = ...;` for a \
             number that points depend on, or leave this out",
        ],
    );
    let effects = good("struct M; param a = 1; effects { sensitivity; }")
        .model
        .effects;
    assert!(effects.sensitivity && !effects.velocity);
    assert_messages(
        "param a = 1; link l { point «p» = (0, 0); point p_sensitivity = (1, 0); } effects { sensitivity; }",
        &[
            "the sensitivity of point `l.p` and point `l.p_sensitivity` would both be the method `l_p_sensitivity`; rename \
             one of them",
        ],
    );
}
