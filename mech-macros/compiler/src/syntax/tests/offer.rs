//! What newcomers write, and that what they are offered instead can be read.

use super::{assert_messages_of, first_offer, parsed, with_offer};

/// One message tells about the mark, and what it offers first is right in the mark's place.
#[track_caller]
fn offered(marked: &str, message: &str) {
    let marked = format!("struct M;\n{marked}");
    assert_messages_of(&marked, &[message]);
    assert_mended(&marked, first_offer(message).expect("an offer"));
}

/// Whether the text is right with this in the place of its mark.
#[track_caller]
fn assert_mended(marked: &str, offer: &str) {
    let mended = with_offer(marked, offer).expect("a mark");
    let errors = parsed(&mended).errors;
    assert!(errors.is_empty(), "{mended}: {errors:?}");
}

/// The value of a constant that is offered.
fn offered_value(wrong: &str) -> f64 {
    let text = format!("struct M; const X = 3; const Y = 4; const A = {wrong};");
    let message = &parsed(&text).errors[0].text;
    let (_, rest) = message.split_once("write `").expect("an offer");
    let (offer, _) = rest.split_once('`').expect("its end");
    let text =
        format!("struct M; const X = 3; const Y = 4; ground {{ point p = (2 / {offer}, 0); }}");
    2.0 / super::good(&text).model.axes[0].at[0]
}

#[test]
fn functions_of_other_languages_are_written_by_ours() {
    for (wrong, value) in [
        ("arccos(-0.9)", (-0.9_f64).acos()),
        ("arcsin(X / 5)", 0.6_f64.asin()),
        ("arctan(X)", 3.0_f64.atan()),
        ("arctan2(-X, 1 - Y)", (-3.0_f64).atan2(-3.0)),
        ("sinh(X - 4)", (-1.0_f64).sinh()),
        ("cosh(2)", 2.0_f64.cosh()),
        ("tanh(-0.5)", (-0.5_f64).tanh()),
        ("exp2(X)", 8.0),
        ("sind(30)", 0.5),
        ("cosd(X * 20)", 0.5),
        ("cot(0.5)", 1.0 / 0.5_f64.tan()),
        ("sec(0.5)", 1.0 / 0.5_f64.cos()),
        ("pow(X + 1, 2)", 16.0),
        ("pow(Y, 0.5)", 2.0),
        ("signum(-X)", -1.0),
        ("ceil(X - 0.5)", 3.0),
        ("(X + Y) % X", 1.0),
        ("radians(90 + 90)", std::f64::consts::PI),
        ("X ^ 2", 9.0),
        ("(X - Y) ** 3", -1.0),
        ("X ^ 1", 3.0),
        ("Y ^ 0.5", 2.0),
    ] {
        let offered = offered_value(wrong);
        assert!(
            (offered - value).abs() < 1e-12,
            "{wrong}: {offered} is not {value}"
        );
    }
}

const CRANK: &str = "ground { point o = (0, 0); } link a { point o = (0, 0); point p = (1, 0); } link b { point p = (0, 0); } \
    joint j = revolute(ground.o, a.o); joint k = revolute(a.p, b.p);\n";

#[test]
fn numbers_have_no_type() {
    assert_mended("struct M; const A«: f64» = 1;", "");
}

#[test]
fn a_ratio_has_two_numbers() {
    let message =
        "a ratio has two numbers; write `1 : 2` if `b` is the larger wheel, or `2 : 1` if `a` is";
    let rolling = "joint g = gear(a, b, «2»";
    offered(&format!("{CRANK}{rolling});"), message);
    offered(&format!("{CRANK}{rolling} on ground);"), message);
    assert_mended(&format!("struct M; {CRANK}{rolling});"), "2 : 1");
    offered(
        &format!("{CRANK}joint g = gear(a, b, «20, 40»);"),
        "a ratio is written with `:`; write `20 : 40`",
    );
    offered(
        &format!("{CRANK}joint g = rack(a, b, «0.5»);"),
        "expected `radius` before this number; write `radius 0.5`",
    );
}

#[test]
fn a_joint_joins_two_links() {
    let text = "link a; link b; joint j = revolute(ground, a, «b») at (0, 0);";
    let message =
        "a joint joins two links; declare another one for the third, as `revolute(ground, b)`";
    super::assert_messages(text, &[message]);
    super::good(
        "struct M; link a; link b; joint j = revolute(ground, a) at (0, 0); joint k = revolute(ground, b) at (0, 0);",
    );
}

#[test]
fn a_name_of_a_color_is_its_entry_of_the_palette() {
    let parsed = super::parsed(
        "struct M; const red = 200; link a { circle (0, 0) radius 1 color teal; ring (0, 0) radius 2 hole 1 color steel dark; \
         circle (0, 0) radius 1 color sky light; circle (0, 0) radius 1 color red; }",
    );
    let colors: Vec<u8> = parsed.model.links[1]
        .shapes
        .iter()
        .map(|shape| shape.color)
        .collect();
    assert_eq!(colors, [4, 32, 42, 200]);
}

#[test]
fn a_motor_has_a_statement_of_its_own() {
    let marked = format!("struct M; {CRANK}motor «j, k»;");
    assert_messages_of(
        &marked,
        &["each motor has its own statement; write `motor j; motor k;`"],
    );
    assert_mended(&marked, "j; motor k");
}

#[test]
fn near_takes_a_link() {
    let marked =
        |settings: &str| format!("struct M; {CRANK}{settings}start {{ «k» near 20 deg; }}");
    let beginning = "`k` is a joint, and `near` takes a link";
    let angle = "write `b near 20 deg`, with the angle of `b` in the scene";
    assert_messages_of(&marked(""), &[&format!("{beginning}; {angle}")]);
    super::good(&format!("struct M; {CRANK}start {{ b near 20 deg; }}"));
    assert_messages_of(
        &marked("motor k; "),
        &[&format!("{beginning}; write `k = 20 deg`")],
    );
    super::good(&format!(
        "struct M; {CRANK}motor k; start {{ k = 20 deg; }}"
    ));
}
