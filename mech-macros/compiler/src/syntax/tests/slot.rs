//! Pins in slots.

use super::joint::{LINKS, joint};
use super::model::named;
use super::{assert_messages, good};
use crate::model::{Axis, AxisId, AxisKind, JointId, JointKind, LinkId, Model};

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
    let motors: Vec<_> = model
        .motors
        .iter()
        .map(|motor| motor.joint.index())
        .collect();
    assert_eq!(motors, [4, 3]);
}

#[test]
fn a_slot_takes_a_point_and_a_line() {
    joint(
        "slot(«rod.way, crank.pin»)",
        &["a `slot` takes the point first, then the line; write `slot(crank.pin, rod.way)`"],
    );
    joint(
        "slot(crank.pin, rod.«eye»)",
        &[
            "`rod.eye` is a point, but `slot` joins a point to a line; name a line, or write `revolute`",
        ],
    );
    joint(
        "slot(crank.«rail», rod.way)",
        &[
            "`crank.rail` is a line, but `slot` joins a point to a line; name a point, or write `prismatic`",
        ],
    );
    joint(
        "slot(crank.«rail», «rood».way)",
        &[
            "`crank.rail` is a line, but `slot` joins a point to a line; name a point",
            "unknown link `rood`; did you mean `rod`?",
        ],
    );
    joint(
        "slot(«crank», rod.way)",
        &[
            "`slot` joins a point to a line, but `crank` is a link; name one of its points, such as `crank.pin`, or \
             place a joint of two links with `at (x, y) along (dx, dy)`",
        ],
    );
    joint(
        "slot(crank.pin, «bare»)",
        &[
            "`slot` joins a point to a line, but `bare` is a link; name one of its lines, declared in `bare`, or place a \
             joint of two links with `at (x, y) along (dx, dy)`",
        ],
    );
    joint(
        "slot(crank.«pni», rod.«wya»)",
        &[
            "`crank` has no point `pni`; did you mean `pin`?",
            "`rod` has no line `wya`; did you mean `way`?",
        ],
    );
    joint(
        "slot(crank.pin, «crank.rail»)",
        &["joint `d` is between `crank` and itself; name two links"],
    );
    joint("slot(crank.pin«)»", &["expected `,` and the second link"]);
}

#[test]
fn a_drawn_slot_has_a_direction() {
    joint(
        "«slot»(crank, rod) at (1, 2)",
        &["a `slot` needs a direction; write `along (dx, dy)` after `at (x, y)`"],
    );
    joint(
        "slot(crank.pin, rod.way) «along» (1, 0)",
        &["`along` without `at`; write `at (x, y) along (dx, dy)` after two links"],
    );
    joint(
        "slot(«crank.pin», rod) at (1, 2) along (1, 0)",
        &["`at` places a joint between links; write `crank` for `crank.pin`, or leave `at` out"],
    );
    joint(
        "slot(crank, rod) at (1, 2) along «(0, 0)»",
        &["a direction cannot be (0, 0); give it a length"],
    );
    joint(
        "slot(rod, «rod») at (1, 2) along (1, 0)",
        &["joint `d` is between `rod` and itself; name two links"],
    );
}

#[test]
fn the_start_of_a_slot_is_that_of_its_slide() {
    let slots = format!(
        "{LINKS}joint d = slot(crank.pin, rod.way); joint e = slot(crank, bare) at (0, 0) along (1, 0);\n"
    );
    assert_messages(
        &format!("{slots}start {{ d = 1; e = «1»; }}"),
        &[
            "joint `e` is placed in the drawing, where its coordinate is 0; leave this out, or draw its links as they are \
             to start",
        ],
    );
    assert_messages(
        &format!("{slots}start {{ d = 1; «d» = 2; «e» near 0; }}"),
        &[
            "there is a start for joint `d` already; remove one of the two",
            "`e` is a joint, and `near` takes a link; choose the assembly by the angle of a link, such as `bare near 0 deg`",
        ],
    );
    assert_messages(
        &format!("{slots}motor d; motor «d»; motor «crank»;"),
        &[
            "joint `d` has a motor already; remove one of the two",
            "`crank` is a link; name one of its joints: `d`, `e`",
        ],
    );
}

#[test]
fn a_bad_slot_leaves_no_die() {
    let text = format!("{LINKS}joint d = slot(crank.«pni», rod.way); motor d; start {{ d = 1; }}");
    let model = assert_messages(&text, &["`crank` has no point `pni`; did you mean `pin`?"]).model;
    assert_eq!((model.links.len(), model.joints.len()), (4, 0));
    let text = format!("{LINKS}joint «rod» = slot(crank.pin, rod.way);");
    let model = assert_messages(
        &text,
        &["there is a link `rod` already; choose another name for this joint"],
    )
    .model;
    assert_eq!((model.links.len(), model.joints.len()), (4, 0));
}
