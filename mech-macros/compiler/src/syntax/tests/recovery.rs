//! Several errors in one text.

use super::assert_messages;

#[test]
fn every_bad_statement_is_told_in_the_order_of_the_text() {
    let parsed = assert_messages(
        "const A = 1 «2»;
        link crank { point pin = (0, «;»); «circl» (0, 0) radius 1; point eye = (A, 0); }
        link rod { point eye = (0, 0); } «foo» { bar; }
        joint a = revolute(crank.pin, rod.«eey»);
        joint b = «hinge»(crank, rod);
        motor «c»;
        motor a;
        start { «c» = 1; a = «sqrt»; rod near 1 +«;» crank near 0; }
        method «fast»;
        link last;",
        &[
            "expected `;`, found `2`",
            "expected a number, found `;`",
            "unknown item `circl`; did you mean `circle`?",
            "unknown statement `foo`; a statement begins with one of `const`, `param`, `ground`, `link`, `joint`, `motor`, \
             `start`, `method`, `accuracy`, `cost`, `at`, `allow`, …",
            "`rod` has no point `eey`; did you mean `eye`?",
            "expected a kind of joint, found `hinge`; there are `revolute`, `prismatic`, `gear`, `slot`, `rack`, \
             `belt`, `weld`, `cam`",
            "unknown joint `c`; there are `a`, `b`",
            "unknown joint `c`; there are `a`, `b`",
            "`sqrt` is a function; write what it is of, as `sqrt(...)`",
            "expected a number, found `;`",
            "unknown method `fast`; there are `exact`, `newton`, `linear`",
        ],
    );
    assert_eq!(parsed.model.links.len(), 4);
    assert_eq!(parsed.model.start.near.len(), 1);
}

#[test]
fn a_missing_semicolon_costs_one_statement() {
    let parsed = assert_messages(
        "const A = «1»\nlink a { point p = (0, 0«)»\npoint q = (0, 0); }\n\
         joint d = revolute(ground, a) at (0, 0«)»\nmotor «d»\nlink b;",
        &[
            "expected `;` after `1`",
            "expected `;` after `)`",
            "expected `;` after `)`",
            "expected `;` after `d`",
        ],
    );
    assert_eq!(parsed.model.links.len(), 3);
    assert_eq!(parsed.model.axes.len(), 2);
}

#[test]
fn a_setting_after_a_missing_semicolon_is_read() {
    use crate::model::{AtChangePoints, Target};
    let parsed = assert_messages(
        "joint d = revolute(ground, a) at (0, 0«)»\nat change points stop; link «a»\naccuracy 1e-9;\n\
         const A = «1»\ncost cortex_m4f; link b;",
        &[
            "expected `;` after `)`",
            "expected `{` or `;` after `a`",
            "expected `;` after `1`",
        ],
    );
    let model = &parsed.model;
    assert_eq!((model.links.len(), model.accuracy), (3, Some(1e-9)));
    assert_eq!(model.change_points, AtChangePoints::Stop);
    assert_eq!(model.target, Target::CortexM4f);
}

#[test]
fn a_drawn_joint_with_an_error_is_one_statement() {
    let parsed = assert_messages(
        "link a; joint d = «revolut»(ground, a) at (1, 2); joint e = «prismat»(ground, a) at (1, 2) along (1, 0);\n\
         joint g = revolute(ground «a») at (1, 2); link b;",
        &[
            "expected a kind of joint, found `revolut`; did you mean `revolute`?",
            "expected a kind of joint, found `prismat`; did you mean `prismatic`?",
            "expected `,` and the second link, found `a`",
        ],
    );
    assert_eq!(parsed.model.links.len(), 3);
}

#[test]
fn a_lost_name_may_be_declared_after_all() {
    let parsed = assert_messages(
        "«lnk» a; link a { point p = (0, 0); } link b { point q = (0, 0); }\n\
         joint d = revolute(a.p, b.«r»);",
        &[
            "unknown statement `lnk`; did you mean `link`?",
            "`b` has no point `r`; there is only `q`",
        ],
    );
    assert_eq!(parsed.model.links.len(), 3);
}
