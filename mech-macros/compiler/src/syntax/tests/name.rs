//! Names that are taken, reserved, or no names.

use super::assert_messages;

#[test]
fn a_doubled_link_is_told_once() {
    let parsed = assert_messages(
        "link a { point p = (0, 0); } link «a» { point q = (0, 0); } link b { point r = (0, 0); }\n\
         joint d = revolute(a.q, b.r);",
        &["there is a link `a` already; choose another name for this link"],
    );
    assert_eq!(parsed.model.links.len(), 3);
}

#[test]
fn a_doubled_joint_is_left_out() {
    let parsed = assert_messages(
        "link a; link b; joint d = gear(a, b, 1 : 2); joint «d» = gear(b, a, 1 : 2);",
        &["there is a joint `d` already; choose another name for this joint"],
    );
    assert_eq!(parsed.model.joints.len(), 1);
}

#[test]
fn some_methods_are_reserved() {
    for name in ["new", "move_to", "motors", "poses", "draw", "clone", "fmt"] {
        let message =
            format!("`{name}` is a method of every mechanism; choose another name for this link");
        let parsed = assert_messages(
            &format!("link «{name}» {{ point p = (0, 0); }} motor {name};"),
            &[&message],
        );
        assert_eq!(parsed.model.links.len(), 1);
    }
}
