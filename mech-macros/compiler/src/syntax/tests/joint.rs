//! Joints.

use super::told;

/// Two links with a point and a line each, and a ground with a point.
const LINKS: &str = "ground { point o = (0, 0); } link crank { point pin = (0, 0); line rail = (0, 0) -> (1, 0); }\n\
    link rod { point eye = (0, 0); line way = (0, 0) -> (1, 0); } link bare;\n";

fn joint(marked: &str, messages: &[&str]) {
    told(&format!("{LINKS}joint d = {marked};"), messages);
}

#[test]
fn axes_must_be_of_the_right_kind() {
    joint(
        "revolute(crank.«rail», rod.eye)",
        &[
            "`crank.rail` is a line, but `revolute` joins points; name a point, or write `prismatic`",
        ],
    );
    joint(
        "prismatic(crank.rail, rod.«eye»)",
        &["`rod.eye` is a point, but `prismatic` joins lines; name a line, or write `revolute`"],
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
        &["expected `)`, found `bare`"],
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
fn gears_join_links() {
    joint(
        "gear(«crank.pin», rod, 20 : 40)",
        &["`gear` joins links; write `crank` for `crank.pin`"],
    );
    joint(
        "gear(crank, rod«)»",
        &["expected `,` and the teeth of both wheels, as `20 : 40`"],
    );
    joint("gear(crank, rod, 20«)»", &["expected `:`"]);
    joint(
        "gear(crank, rod, «0» : 40)",
        &["a wheel cannot be of size zero; give its teeth or its pitch radius"],
    );
    joint(
        "gear(crank, rod, 20 : «1 - 1»)",
        &["a wheel cannot be of size zero; give its teeth or its pitch radius"],
    );
    joint(
        "gear(crank, rod, «-20 : -40»)",
        &["only one wheel of a gear can be a ring; make one of the two positive"],
    );
    joint(
        "gear(crank, rod, «99999999999999999999» : 1)",
        &["no wheel has that many teeth; a pitch radius has a decimal point"],
    );
    joint(
        "gear(crank, rod, 20 : 40 «on» bare)",
        &["naming the carrier of a gear with `on` is not supported yet"],
    );
    joint(
        "gear(crank, rod, 20 : 40) «at» (0, 0)",
        &["a `gear` has no place of its own; its wheels turn where their other joints hold them"],
    );
}

#[test]
fn some_joints_are_to_come() {
    let not_yet = |kind| format!("`{kind}` joints are not supported yet");
    joint("«slot»(crank.pin, rod.way)", &[&not_yet("slot")]);
    joint(
        "«slot»(crank, rod) at (1, 2) along (3, 4)",
        &[&not_yet("slot")],
    );
    joint("«rack»(crank, rod, radius 0.5)", &[&not_yet("rack")]);
    joint("«belt»(crank, rod, 1.0 : 3.0)", &[&not_yet("belt")]);
    joint("«weld»(crank, rod)", &[&not_yet("weld")]);
    joint("«weld»(crank, rod) at (3, 0)", &[&not_yet("weld")]);
    joint(
        "«weld»(crank, «rood»)",
        &[&not_yet("weld"), "unknown link `rood`; did you mean `rod`?"],
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
    let parsed = told(&text, &["`crank` has no point `pni`; did you mean `pin`?"]);
    assert!(parsed.model.joints.is_empty() && parsed.model.motors.is_empty());
    assert_eq!(parsed.motors, 1);
}
