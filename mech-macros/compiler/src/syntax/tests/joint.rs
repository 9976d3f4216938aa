//! Joints.

use super::assert_messages;

/// Two links with a point and a line each, and a ground with a point.
pub(super) const LINKS: &str = "ground { point o = (0, 0); } link crank { point pin = (0, 0); line rail = (0, 0) -> (1, 0); }\n\
    link rod { point eye = (0, 0); line way = (0, 0) -> (1, 0); } link bare;\n";

pub(super) fn joint(marked: &str, messages: &[&str]) {
    assert_messages(&format!("{LINKS}joint d = {marked};"), messages);
}

#[test]
fn axes_must_be_of_the_right_kind() {
    joint(
        "revolute(crank.«rail», rod.eye)",
        &[
            "`crank.rail` is a line, but `revolute` joins points; name a point, or write `slot(rod.eye, crank.rail)`",
        ],
    );
    joint(
        "revolute(crank.pin, rod.«way»)",
        &[
            "`rod.way` is a line, but `revolute` joins points; name a point, or write `slot(crank.pin, rod.way)`",
        ],
    );
    joint(
        "prismatic(crank.rail, rod.«eye»)",
        &[
            "`rod.eye` is a point, but `prismatic` joins lines; name a line, or write `slot(rod.eye, crank.rail)`",
        ],
    );
    let line = |axis| {
        format!(
            "`{axis}` is a line, but `revolute` joins points; name a point, or write `prismatic`"
        )
    };
    joint(
        "revolute(crank.«rail», rod.«way»)",
        &[&line("crank.rail"), &line("rod.way")],
    );
    joint(
        "revolute(crank.«rail», «rood».eye)",
        &[
            &line("crank.rail"),
            "unknown link `rood`; did you mean `rod`?",
        ],
    );
    let point = |axis| {
        format!(
            "`{axis}` is a point, but `prismatic` joins lines; name a line, or write `revolute`"
        )
    };
    joint(
        "prismatic(crank.«pin», rod.«eye»)",
        &[&point("crank.pin"), &point("rod.eye")],
    );
}

#[test]
fn unknown_names_have_a_remedy() {
    joint(
        "revolute(«crnk».pin, rod.eye)",
        &["unknown link `crnk`; did you mean `crank`?"],
    );
    joint(
        "revolute(«x1234».pin, rod.eye)",
        &["unknown link `x1234`; there are `ground`, `crank`, `rod`, `bare`"],
    );
    joint(
        "revolute(crank.«pni», rod.eye)",
        &["`crank` has no point `pni`; did you mean `pin`?"],
    );
    joint(
        "revolute(crank.«hole», rod.eye)",
        &["`crank` has no point `hole`; there is only `pin`"],
    );
    joint(
        "revolute(bare.«hole», rod.eye)",
        &["`bare` has no point `hole`; declare it in `bare`"],
    );
    joint(
        "prismatic(ground.«o2», «rdo».way)",
        &[
            "`ground` has no line `o2`; declare it in `ground`",
            "unknown link `rdo`; did you mean `rod`?",
        ],
    );
    joint(
        "revolute(«d».pin, rod.eye)",
        &["`d` is a joint; this must be a link, one of `ground`, `crank`, `rod`, `bare`"],
    );
}

#[test]
fn a_joint_is_between_two_links() {
    joint(
        "revolute(crank.pin, «crank.pin»)",
        &["joint `d` is between `crank` and itself; name two links"],
    );
    joint(
        "prismatic(rod, «rod») at (0, 0) along (1, 0)",
        &["joint `d` is between `rod` and itself; name two links"],
    );
    joint(
        "gear(rod, «rod», 1 : 2)",
        &["joint `d` is between `rod` and itself; name two links"],
    );
    joint(
        "revolute(crank.pin«)»",
        &["expected `,` and the second link"],
    );
    joint(
        "revolute(crank.pin, rod.eye, «bare»)",
        &[
            "a joint joins two links; declare another one for the third, as `revolute(crank.pin, bare)`",
        ],
    );
}

#[test]
fn links_are_joined_where_they_are_drawn() {
    joint(
        "revolute(«crank», rod.eye)",
        &[
            "`revolute` joins points, but `crank` is a link; name one of its points, such as `crank.pin`, or place a \
           joint of two links with `at (x, y)`",
        ],
    );
    joint(
        "prismatic(crank.rail, «bare»)",
        &[
            "`prismatic` joins lines, but `bare` is a link; name one of its lines, declared in `bare`, or place a joint \
           of two links with `at (x, y) along (dx, dy)`",
        ],
    );
    joint(
        "revolute(«crank.pin», rod) at (0, 0)",
        &["`at` places a joint between links; write `crank` for `crank.pin`, or leave `at` out"],
    );
    joint(
        "revolute(crank, rod) at (0, 0) «along» (1, 0)",
        &["a `revolute` has no direction; leave `along` out, or write `prismatic`"],
    );
    joint(
        "«prismatic»(crank, rod) at (0, 0)",
        &["a `prismatic` needs a direction; write `along (dx, dy)` after `at (x, y)`"],
    );
    joint(
        "prismatic(crank, rod) at (0, 0) along «(0, 0)»",
        &["a direction cannot be (0, 0); give it a length"],
    );
    joint(
        "prismatic(crank.rail, rod.way) «along» (1, 0)",
        &["`along` without `at`; write `at (x, y) along (dx, dy)` after two links"],
    );
    joint(
        "revolute(crank, rod) at («1 / 0», 0)",
        &["division by zero"],
    );
}

#[test]
fn other_joints_are_unknown() {
    joint(
        "«revolut»(crank.pin, rod.eye)",
        &["expected a kind of joint, found `revolut`; did you mean `revolute`?"],
    );
    joint("«1»", &["expected a kind of joint, found `1`"]);
    joint("revolute «crank»", &["expected `(`, found `crank`"]);
}

#[test]
fn a_bad_joint_is_left_out_and_not_missed() {
    let text =
        format!("{LINKS}joint d = revolute(crank.«pni», rod.eye); motor d; start {{ d = 0; }}");
    let parsed = assert_messages(&text, &["`crank` has no point `pni`; did you mean `pin`?"]);
    assert!(parsed.model.joints.is_empty() && parsed.model.motors.is_empty());
    assert_eq!(parsed.motors, 1);
}
