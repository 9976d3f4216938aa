//! Params: what they are, where they may stand, and what is told where they may not.

use super::good;
use crate::model::{Axis, Model, Now};

fn axis<'m>(model: &'m Model, name: &str) -> &'m Axis {
    let mut axes = model.axes.iter();
    axes.find(|axis| axis.name.as_deref() == Some(name)).expect("it was declared")
}

#[test]
fn a_place_may_depend_on_params() {
    let text = "struct M; param length = 3 + 1; param angle = 30 deg; const HALF = length / 2; const FIXED = 2 * 3;
        link l { point a = (length, -HALF); point b = (FIXED, 1); point c = (cos(angle) * length, tan(angle) * 2); }";
    let model = good(text).model;
    let names: Vec<(&str, f64)> =
        model.params.all().iter().map(|param| (param.name.as_str(), param.value)).collect();
    assert_eq!(names, [("length", 4.0), ("angle", 30.0_f64.to_radians())]);
    assert_eq!(axis(&model, "a").at, [4.0, -2.0]);
    assert!(axis(&model, "a").formulas.iter().all(Option::is_some));
    assert!(!axis(&model, "b").varies());
    let (sin, cos) = (libm::sin(30.0_f64.to_radians()), libm::cos(30.0_f64.to_radians()));
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
        let variables = &[];
        model.params.evaluate(&mut Now { variables, params })
    };
    let turned = |axis: &Axis, params: &[f64]| {
        axis.direction_formulas.map(|formula| now(params)[formula.expect("both").index()])
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
}

#[test]
fn equal_formulas_are_one() {
    let text = "struct M; param x = 3; link l { point a = (x * 2, 0); point b = (x * 2, 1); }";
    let model = good(text).model;
    assert_eq!(axis(&model, "a").formulas[0], axis(&model, "b").formulas[0]);
}

#[test]
fn what_follows_no_param_has_no_sensitivity() {
    let effects = good("struct M; param a = 1; effects { sensitivity; }").model.effects;
    assert!(effects.sensitivity && !effects.velocity);
}
