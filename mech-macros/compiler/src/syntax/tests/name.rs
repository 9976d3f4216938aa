//! Names that are taken, reserved, or no names.

use super::assert_messages;

#[test]
fn links_and_joints_share_their_names() {
    assert_messages(
        "link a; link «a»;",
        &["there is a link `a` already; choose another name for this link"],
    );
    assert_messages(
        "link a; link b; joint «a» = gear(a, b, 1 : 2);",
        &["there is a link `a` already; choose another name for this joint"],
    );
    assert_messages(
        "link a; link b; joint c = gear(a, b, 1 : 2); link «c»;",
        &["there is a joint `c` already; choose another name for this link"],
    );
    assert_messages("link a; const a = 1; link b { point a = (a, 0); }", &[]);
}

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
fn points_and_lines_of_a_link_share_their_names() {
    assert_messages(
        "link a { point p = (0, 0); line «p» = (0, 0) -> (1, 0); } link b { point p = (0, 0); }",
        &["`a` has a point `p` already; choose another name"],
    );
}

#[test]
fn methods_do_not_clash() {
    assert_messages(
        "link a { point b = (0, 0); } link «a_b»;",
        &["link `a_b` and point `a.b` would both be the method `a_b`; rename one of them"],
    );
    assert_messages(
        "link a_b { point c = (0, 0); } link a { point «b_c» = (0, 0); }",
        &["point `a.b_c` and point `a_b.c` would both be the method `a_b_c`; rename one of them"],
    );
    assert_messages(
        "link a; link b; joint a_p = gear(a, b, 1 : 2); link c { point p = (0, 0); } ground { point p = (0, 0); }\n\
         link ground_q; link move_x;",
        &[],
    );
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
    assert_messages(
        "link «ground»;",
        &["`ground` is the link that is fixed; choose another name for this link"],
    );
    assert_messages(
        "link a; link b; joint «ground» = gear(a, b, 1 : 2);",
        &["`ground` is the link that is fixed; choose another name for this joint"],
    );
}

#[test]
fn names_are_names() {
    assert_messages(
        "link «type»;",
        &["`type` is a keyword of Rust; choose another name"],
    );
    // In edition 2024, in which generated code is written.
    assert_messages(
        "link «gen»;",
        &["`gen` is a keyword of Rust; choose another name"],
    );
    assert_messages(
        "link «_»;",
        &["expected the name of a link, found `_`; give it a name"],
    );
    assert_messages(
        "link «r#type»;",
        &["`r#type` is a raw identifier; choose a plain name"],
    );
    assert_messages("link «5»;", &["expected the name of a link, found `5`"]);
    assert_messages("link «{»}", &["expected the name of a link, found `{`"]);
    assert_messages(
        "const «fn» = 1;",
        &["`fn` is a keyword of Rust; choose another name"],
    );
    assert_messages(
        "link a { point «self» = (0, 0); }",
        &["`self` is a keyword of Rust; choose another name"],
    );
    assert_messages(
        "motor «r#d»;",
        &["`r#d` is a raw identifier; choose a plain name"],
    );
}
