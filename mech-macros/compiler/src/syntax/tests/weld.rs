//! Links that are one.

use super::joint::{LINKS, joint};
use super::model::{self, named};
use super::{assert_messages, good};
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

#[test]
fn lines_are_not_welded() {
    joint(
        "weld(crank.«rail», rod.eye)",
        &["`crank.rail` is a line, but `weld` joins points; name a point"],
    );
    joint(
        "weld(crank.«rail», rod.«way»)",
        &[
            "`crank.rail` is a line, but `weld` joins points; name a point",
            "`rod.way` is a line, but `weld` joins points; name a point",
        ],
    );
}

#[test]
fn points_or_links_are_welded() {
    joint(
        "weld(crank.pin, «rod»)",
        &[
            "`weld` joins points, but `rod` is a link; name one of its points, such as `rod.eye`, or join the whole links \
             with `weld(crank, rod)`",
        ],
    );
    joint(
        "weld(«bare», rod.eye)",
        &[
            "`weld` joins points, but `bare` is a link; name one of its points, declared in `bare`, or join the whole \
             links with `weld(bare, rod)`",
        ],
    );
    joint(
        "weld(«crnk», «rood»)",
        &[
            "unknown link `crnk`; did you mean `crank`?",
            "unknown link `rood`; did you mean `rod`?",
        ],
    );
    joint(
        "weld(crank.pin, rod.«eey»)",
        &["`rod` has no point `eey`; did you mean `eye`?"],
    );
    joint(
        "weld(crank, «crank»)",
        &["joint `d` is between `crank` and itself; name two links"],
    );
    joint(
        "weld(crank.pin, «crank.pin»)",
        &["joint `d` is between `crank` and itself; name two links"],
    );
    joint(
        "weld(crank, «crank») at (0, 0)",
        &["joint `d` is between `crank` and itself; name two links"],
    );
}

#[test]
fn a_weld_has_no_direction() {
    let direction = "a `weld` has no direction; leave `along` out";
    joint("weld(crank, rod) «along» (1, 0)", &[direction]);
    joint("weld(crank.pin, rod.eye) «along» (1, 0)", &[direction]);
    joint("weld(crank, rod) at (1, 2) «along» (1, 0)", &[direction]);
    joint(
        "weld(crank, «rod.eye») at (1, 2)",
        &["`at` places a joint between links; write `rod` for `rod.eye`, or leave `at` out"],
    );
    joint("weld(crank, rod) at («1 / 0», 2)", &["division by zero"]);
}

#[test]
fn a_weld_is_no_place_for_a_motor() {
    assert_messages(
        &format!("{LINKS}joint d = weld(crank, rod); motor «crank»;"),
        &["`crank` is a link; this must be a joint"],
    );
}
