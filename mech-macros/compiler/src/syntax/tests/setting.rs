//! The start, and what is wanted and let pass.

use super::assert_messages;
use crate::syntax::Parsed;

const CRANK: &str = "ground { point o = (0, 0); line l = (0, 0) -> (1, 0); } link crank { point p = (0, 0); } link wheel;\n\
    joint shaft = revolute(ground.o, crank.p); joint mesh = gear(crank, wheel, 1 : 2);\n\
    joint drawn = revolute(ground, wheel) at (3, 0);\n";

pub(super) fn with_crank(marked: &str, messages: &[&str]) -> Parsed {
    assert_messages(&format!("{CRANK}{marked}"), messages)
}

#[test]
fn the_start_names_joints_and_links() {
    with_crank(
        "start { «crank» = 0; }",
        &["`crank` is a link; write `crank near 0` to choose the assembly nearest to an angle"],
    );
    with_crank(
        "start { «shaft» near 0; }",
        &[
            "`shaft` is a joint, and `near` takes a link; write `crank near 0`, with the angle of `crank` in the scene",
        ],
    );
    with_crank(
        "start { «shft» = 0; }",
        &["unknown joint `shft`; did you mean `shaft`?"],
    );
    with_crank(
        "start { «crnk» near 0; }",
        &["unknown link `crnk`; did you mean `crank`?"],
    );
    with_crank(
        "start { «ground» near 0; }",
        &["`ground` is fixed; leave this out"],
    );
    with_crank(
        "start { «mesh» = 0; }",
        &["`mesh` is a gear, which has no coordinate; give that of the joint of one of its wheels"],
    );
    with_crank(
        "joint run = belt(crank, wheel, 1 : 2); start { «run» = 0; }",
        &["`run` is a belt, which has no coordinate; give that of the joint of one of its wheels"],
    );
    with_crank(
        "joint bar = rack(crank, wheel, radius 1); start { «bar» = 0; }",
        &[
            "`bar` is a rack, which has no coordinate; give that of the joint of its pinion or its bar",
        ],
    );
    with_crank(
        "joint fix = weld(crank, wheel); start { «fix» = 0; }",
        &["`fix` is a weld, which has no coordinate; leave this out"],
    );
    with_crank(
        "start { shaft «0»; }",
        &["expected `=` (for a joint) or `near` (for a link), found `0`"],
    );
    with_crank("start { shaft = «1 / 0»; }", &["division by zero"]);
}

#[test]
fn the_start_says_things_once() {
    with_crank(
        "start { shaft = 0; «shaft» = 1; crank near 0; «crank» near 1; }",
        &[
            "there is a start for joint `shaft` already; remove one of the two",
            "there is a `near` for link `crank` already; remove one of the two",
        ],
    );
    with_crank(
        "start { shaft = 0; } «start» { }",
        &["a mechanism has one `start`; put everything into the first"],
    );
}

#[test]
fn a_drawn_joint_starts_at_zero() {
    with_crank("start { drawn = 1 - 1; }", &[]);
    with_crank(
        "start { drawn = «90 deg»; }",
        &[
            "joint `drawn` is placed in the drawing, where its coordinate is 0; leave this out, or draw its links as they \
           are to start",
        ],
    );
}

#[test]
fn some_settings_are_to_come() {
    assert_messages("«certify»;", &["`certify` is not supported yet"]);
}

#[test]
fn accelerations_bring_velocities_with_them() {
    use crate::model::Effects;
    let effects = |text| {
        let Effects {
            velocity,
            acceleration,
            ..
        } = assert_messages(text, &[]).model.effects;
        [velocity, acceleration]
    };
    assert_eq!(effects(""), [false, false]);
    assert_eq!(effects("effects { velocity; }"), [true, false]);
    assert_eq!(effects("effects { acceleration; }"), [true, true]);
    assert_messages(
        "effects { velocity; «velocity»; «speed»; }",
        &[
            "`velocity` is listed already; remove one of the two",
            "unknown effect `speed`; there are `velocity`, `acceleration`, `force`, `dynamics`, `trace`, `overlay`, `sensitivity`",
        ],
    );
}

#[test]
fn some_things_are_let_pass() {
    use crate::model::Allowances;
    let allow = |text| {
        let Allowances { redundant, coupled } = assert_messages(text, &[]).model.allow;
        [redundant, coupled]
    };
    assert_eq!(allow(""), [false, false]);
    assert_eq!(allow("allow redundant;"), [true, false]);
    assert_eq!(allow("allow coupled; allow redundant;"), [true, true]);
    assert_messages(
        "allow coupled; allow redundant; allow «coupled»;",
        &["`coupled` is allowed already; remove one of the two"],
    );
    assert_messages(
        "allow «couple»;",
        &["unknown permission `couple`; did you mean `coupled`?"],
    );
    assert_messages(
        "allow«;»",
        &["expected `redundant` or `coupled`, found `;`"],
    );
}

#[test]
fn what_is_shown_must_exist() {
    with_crank(
        "show «crnk», crank.«q», «shaft».p;",
        &[
            "unknown link or joint `crnk`; did you mean `crank`?",
            "`crank` has no point `q`; there is only `p`",
            "`shaft` is a joint; this must be a link, one of `ground`, `crank`, `wheel`",
        ],
    );
}

#[test]
fn what_is_shown_is_noted() {
    use crate::model::{AxisId, JointId, LinkId, Shown};
    let show = |text| with_crank(text, &[]).model.show;
    assert_eq!(show(""), None);
    let (crank, wheel) = (LinkId::new(1), LinkId::new(2));
    assert_eq!(
        show("show crank, drawn; motor shaft;"),
        Some(vec![Shown::Link(crank), Shown::Joint(JointId::new(2))])
    );
    // The third axis of the text, after the two of the ground.
    assert_eq!(
        show("show wheel, crank.p, shaft,; motor shaft;"),
        Some(vec![
            Shown::Link(wheel),
            Shown::Point(AxisId::new(2)),
            Shown::Joint(JointId::new(0))
        ])
    );
}

#[test]
fn what_is_shown_has_to_be_computed() {
    with_crank(
        "show «ground», crank;",
        &["`ground` does not move: there is nothing to compute; leave this out"],
    );
    with_crank(
        "show crank, «ground.o»;",
        &["`ground.o` does not move: there is nothing to compute; leave this out"],
    );
    with_crank(
        "show ground.«l»;",
        &["`ground.l` is a line; leave this out"],
    );
    with_crank(
        "show last.«rail»; link last { line rail = (0, 0) -> (1, 0); }",
        &["`last.rail` is a line; show its link, `last`"],
    );
    with_crank(
        "show «mesh»;",
        &["`mesh` is a gear, which has no coordinate; show that of the joint of one of its wheels"],
    );
    with_crank(
        "joint fix = weld(crank, wheel); show «fix»;",
        &["`fix` is a weld, which has no coordinate; leave this out"],
    );
    with_crank(
        "«show» shaft; motor shaft;",
        &[
            "nothing of this has to be computed: it is what the motors are given; show what they move, or leave this out",
        ],
    );
}

#[test]
fn things_are_shown_once() {
    with_crank(
        "show crank, shaft, «crank», «shaft»;",
        &[
            "`crank` is shown already; remove one of the two",
            "`shaft` is shown already; remove one of the two",
        ],
    );
    with_crank(
        "show crank, «crank.p»;",
        &["`crank.p` is shown with its link already; leave this out"],
    );
    with_crank(
        "show «crank.p», crank;",
        &["`crank.p` is shown with its link already; leave this out"],
    );
    with_crank(
        "show crank; «show» wheel;",
        &["a mechanism has one `show`; put everything into the first"],
    );
}

#[test]
fn what_is_continuous_turns_and_is_shown() {
    use crate::model::JointId;
    let continuous = |text| with_crank(text, &[]).model.continuous;
    assert_eq!(continuous(""), []);
    assert_eq!(continuous("continuous shaft,;"), [JointId::new(0)]);
    assert_eq!(
        continuous("continuous drawn, shaft; show crank, shaft, drawn; motor shaft;"),
        [JointId::new(2), JointId::new(0)]
    );
    with_crank(
        "continuous «shft», «crank», «p»;",
        &[
            "unknown joint `shft`; did you mean `shaft`?",
            "`crank` is a link; name one of its joints: `shaft`",
            "`p` is a point of link `crank`, not a joint: a joint joins two links; there are `shaft`, `mesh`, `drawn`",
        ],
    );
    with_crank(
        "continuous drawn, «mesh», «drawn»;",
        &[
            "`mesh` is a gear, which has no coordinate; ask for that of the joint of one of its wheels",
            "`drawn` is continuous already; remove one of the two",
        ],
    );
    with_crank(
        "link block; joint way = prismatic(ground, block) at (0, 0) along (1, 0); continuous «way»;",
        &["joint `way` slides: its coordinate has no turns; leave this out"],
    );
    with_crank(
        "continuous drawn, «shaft»; show crank, drawn;",
        &["`show` leaves the coordinate of `shaft` out; add it there, or leave this out"],
    );
    with_crank(
        "continuous drawn; «continuous» shaft;",
        &["a mechanism has one `continuous`; put all joints into the first"],
    );
    assert_messages(
        "continuous«;»",
        &["expected the name of a joint, found `;`"],
    );
}
