//! Pins in slots, and links that are one.

use super::good;
use super::model::{self, named};
use crate::model::{Axis, AxisId, AxisKind, JointId, JointKind, LinkId, Model};

/// Links that are joined.
pub(super) const LINKS: &str = "ground { point o = (0, 0); } link crank { point pin = (0, 0); line rail = (0, 0) -> (1, 0); }\n\
    link rod { point eye = (0, 0); line way = (0, 0) -> (1, 0); } link bare;\n";

/// Looks at the joints of the only slot, which is called `d`: its point, its line and its slide.
fn parts(model: &Model) -> (AxisId, AxisId, JointId) {
    let [pivot, slide] = model.joints.as_slice() else {
        panic!("a pivot and a slide");
    };
    assert_eq!((pivot.name.as_str(), pivot.hidden), ("d", true));
    assert_eq!((slide.name.as_str(), slide.hidden), ("d", false));
    let (JointKind::Revolute(point, pin), JointKind::Prismatic(line, guide)) =
        (pivot.kind, slide.kind)
    else {
        panic!("a revolute and a prismatic");
    };
    let die = model.links.last().expect("a die");
    assert_eq!((die.name.as_str(), die.die), ("d", Some((point, line))));
    assert!(!die.drawn);
    let die = LinkId::new(model.links.len() - 1);
    assert_eq!((model.axis(pin).link, model.axis(guide).link), (die, die));
    (point, line, JointId::new(1))
}

#[test]
fn a_pin_is_in_a_slot() {
    let parsed = good(&format!(
        "struct M; joint d = slot(crank.pin, rod.way); {LINKS} motor d; start {{ d = 0.3; }}"
    ));
    let model = &parsed.model;
    let (point, line, slide) = parts(model);
    assert_eq!(point, named(model, "crank", "pin").0);
    assert_eq!(line, named(model, "rod", "way").0);
    let declared: Vec<_> = model.declared_links().map(LinkId::index).collect();
    assert_eq!((declared, model.links.len()), (vec![1, 2, 3], 5));
    assert!(model.links.iter().all(|link| !link.drawn));
    assert_eq!(model.motors[0].joint, slide);
    let start = model.start.values[0];
    assert_eq!((start.joint, start.value), (slide, 0.3));
}

#[test]
fn a_slot_is_drawn() {
    let parsed = good(
        "struct M; link a; link b; joint d = slot(a, b) at (1, 2) along (0, 2); start { d = 0; }",
    );
    let model = &parsed.model;
    let (point, line, _) = parts(model);
    let drawn = |link, kind, direction| Axis {
        link: LinkId::new(link),
        name: None,
        port: None,
        origin: model.joints[0].origin,
        kind,
        at: [1.0, 2.0],
        formulas: [None; 2],
        direction_formulas: [None; 2],
        direction,
    };
    assert_eq!(model.axis(point), &drawn(1, AxisKind::Point, [1.0, 0.0]));
    assert_eq!(model.axis(line), &drawn(2, AxisKind::Line, [0.0, 1.0]));
    let drawn: Vec<_> = model.links.iter().map(|link| link.drawn).collect();
    assert_eq!(drawn, [false, true, true, false]);
}

#[test]
fn the_ground_may_have_the_slot() {
    let parsed = good("struct M; link a; joint d = slot(a, ground) at (1, 2) along (1, 0);");
    let (_, line, _) = parts(&parsed.model);
    assert_eq!(parsed.model.axis(line).link, LinkId::GROUND);
    assert!(!parsed.model.link(LinkId::GROUND).drawn);
}

#[test]
fn dies_come_after_all_links() {
    let parsed = good(&format!(
        "struct M; joint d = slot(crank.pin, rod.way); joint e = slot(rod.eye, last.rail); {LINKS}
        link last {{ line rail = (0, 0) -> (1, 0); }} joint f = revolute(ground, last) at (0, 0);
        motor f; motor e;"
    ));
    let model = &parsed.model;
    let links: Vec<_> = model.links.iter().map(|link| link.name.as_str()).collect();
    assert_eq!(links, ["ground", "crank", "rod", "bare", "last", "d", "e"]);
    let motors: Vec<_> = model.motors.iter().map(|motor| motor.joint.index()).collect();
    assert_eq!(motors, [4, 3]);
}

/// The axes of the weld that is called `d`.
fn welded(model: &Model) -> [&Axis; 2] {
    match model::joint(model, "d") {
        JointKind::Weld(a, b) => [model.axis(a), model.axis(b)],
        _ => panic!("a weld"),
    }
}

#[test]
fn frames_are_welded() {
    let parsed = good("struct M; joint d = weld(ground, a); link a; joint e = weld(a, b); link b;");
    let model = &parsed.model;
    for (axis, link) in welded(model).into_iter().zip(0..) {
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
    for (axis, link) in welded(&parsed.model).into_iter().zip(1..) {
        assert_eq!((axis.link, &axis.name), (LinkId::new(link), &None));
        assert_eq!(axis.kind, AxisKind::Point);
        assert_eq!((axis.at, axis.direction), ([3.0, 0.0], [1.0, 0.0]));
    }
    let drawn: Vec<_> = parsed.model.links.iter().map(|link| link.drawn).collect();
    assert_eq!(drawn, [false, true, true]);
}

#[test]
fn points_are_welded() {
    let parsed = good(&format!("struct M; {LINKS} joint d = weld(crank.pin, rod.eye);"));
    let model = &parsed.model;
    let (pin, eye) = (named(model, "crank", "pin").0, named(model, "rod", "eye").0);
    assert_eq!(model::joint(model, "d"), JointKind::Weld(pin, eye));
    assert!(model.links.iter().all(|link| !link.drawn));
}
