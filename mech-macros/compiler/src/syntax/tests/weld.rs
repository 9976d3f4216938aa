//! Links that are one.

use super::good;
use super::model::{self, named};
use super::slot::LINKS;
use crate::model::{Axis, AxisKind, JointKind, LinkId, Model};

/// The axes of the weld that is called `d`.
fn ends(model: &Model) -> [&Axis; 2] {
    match model::joint(model, "d") {
        JointKind::Weld(a, b) => [model.axis(a), model.axis(b)],
        _ => panic!("a weld"),
    }
}

#[test]
fn frames_are_welded() {
    let parsed = good("struct M; joint d = weld(ground, a); link a; joint e = weld(a, b); link b;");
    let model = &parsed.model;
    for (axis, link) in ends(model).into_iter().zip(0..) {
        assert_eq!((axis.link, &axis.name), (LinkId::new(link), &None));
        assert_eq!(axis.kind, AxisKind::Point);
        assert_eq!((axis.at, axis.direction), ([0.0, 0.0], [1.0, 0.0]));
        assert_eq!(axis.origin, model.joints[0].origin);
    }
    assert!(model.links.iter().all(|link| !link.drawn));
    // Both welds have the frame of `a`.
    assert_eq!(model.axes.len(), 3);
}

#[test]
fn a_weld_is_drawn() {
    let parsed = good("struct M; link a; link b; joint d = weld(a, b) at (3, 0);");
    for (axis, link) in ends(&parsed.model).into_iter().zip(1..) {
        assert_eq!((axis.link, &axis.name), (LinkId::new(link), &None));
        assert_eq!(axis.kind, AxisKind::Point);
        assert_eq!((axis.at, axis.direction), ([3.0, 0.0], [1.0, 0.0]));
    }
    let drawn: Vec<_> = parsed.model.links.iter().map(|link| link.drawn).collect();
    assert_eq!(drawn, [false, true, true]);
}

#[test]
fn points_are_welded() {
    let parsed = good(&format!(
        "struct M; {LINKS} joint d = weld(crank.pin, rod.eye);"
    ));
    let model = &parsed.model;
    let (pin, eye) = (named(model, "crank", "pin").0, named(model, "rod", "eye").0);
    assert_eq!(model::joint(model, "d"), JointKind::Weld(pin, eye));
    assert!(model.links.iter().all(|link| !link.drawn));
}
