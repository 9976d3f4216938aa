//! What newcomers write, and that what they are offered instead can be read.

use super::{assert_messages_of, parsed};

/// One message tells about the mark, and what it offers first is right in the mark's place.
#[track_caller]
fn offered(marked: &str, message: &str) {
    let marked = format!("struct M;\n{marked}");
    assert_messages_of(&marked, &[message]);
    let (_, rest) = message.split_once('`').expect("something is quoted");
    let quoted = message.split_once("write `").map_or(rest, |(_, rest)| rest);
    let (offer, _) = quoted.split_once('`').expect("the quote ends");
    assert_mended(&marked, offer);
}

/// Whether the text is right with this in the place of its mark.
#[track_caller]
fn assert_mended(marked: &str, offer: &str) {
    let (before, rest) = marked.split_once('«').expect("a mark");
    let (_, after) = rest.split_once('»').expect("its end");
    let mended = format!("{before}{offer}{after}");
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

#[test]
fn no_function_is_taken_for_another() {
    offered(
        "const A = 1 + «arccos(0.5)»;",
        "there is no `arccos`; write `acos(0.5)`",
    );
    offered(
        "const A = «sgn(-2)»;",
        "there is no `sgn`; write `sign(-2)`",
    );
    super::assert_messages(
        "const A = «arccos»();",
        &[
            "unknown function `arccos`; there are `sqrt`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`, `exp`, `abs`, `floor`, `sign`, `atan2`, `hypot`, `min`, `max`, `mod`",
        ],
    );
    super::assert_messages(
        "const A = «sin»;",
        &["`sin` is a function; write what it is of, as `sin(...)`"],
    );
}

#[test]
fn operators_of_other_languages_are_written_by_ours() {
    offered("const A = 1 - «2^2»;", "there is no `^`; write `(2 * 2)`");
    offered(
        "const A = 8 / «2 ** 3»;",
        "there is no `**`; write `(2 * 2 * 2)`",
    );
    super::assert_messages(
        "const A = «2 ^ 0.3»;",
        &["there is no `^`; write the power as a product, such as `x * x * x`"],
    );
    offered(
        &format!("{CRANK}motor j = «t % 2»;"),
        "there is no `%`; write `mod(t, 2)`",
    );
}

const CRANK: &str = "ground { point o = (0, 0); } link a { point o = (0, 0); point p = (1, 0); } link b { point p = (0, 0); } \
    joint j = revolute(ground.o, a.o); joint k = revolute(a.p, b.p);\n";

#[test]
fn units_are_left_out_or_degrees() {
    for (wrong, message) in [
        ("«60 degrees»", "there is no unit `degrees`; write `60 deg`"),
        (
            "«(1 + 2) degrees»",
            "there is no unit `degrees`; write `(1 + 2) deg`",
        ),
        (
            "«1 rad»",
            "a number without a unit is in radians; write `1`",
        ),
        (
            "«90rad»",
            "a number without a unit is in radians; write `90`",
        ),
        (
            "«1.5 turns»",
            "there is no unit `turns`; write `1.5 * 360 deg`",
        ),
        (
            "2 * «10 mm»",
            "lengths have no unit; write `10`, and all lengths in the same unit",
        ),
        (
            "«10mm»",
            "lengths have no unit; write `10`, and all lengths in the same unit",
        ),
        (
            "«1 kg»",
            "there is no unit `kg`; write `1`, in units that fit the others, such as m, kg and s",
        ),
        ("«1f64»", "a number has no type; write `1`"),
    ] {
        offered(&format!("const A = {wrong};"), message);
    }
    // The name of a joint is no unit.
    super::assert_messages(
        "link b; joint m = revolute(ground, b) at (0, 0); start { b near «1»\nm = 0; }",
        &["expected `;` after `1`"],
    );
}

#[test]
fn numbers_have_no_type() {
    super::assert_messages(
        "const A«: f64» = 1;",
        &["numbers have no type here; leave `: f64` out"],
    );
    assert_mended("struct M; const A«: f64» = 1;", "");
    super::assert_messages(
        "param a«: f32» = 1;",
        &["numbers have no type here; leave `: f32` out"],
    );
}

#[test]
fn paths_of_rust_cannot_be_seen() {
    offered(
        "const A = 2 * «std::f64::consts::PI»;",
        "paths of Rust cannot be seen here; write `PI`",
    );
    offered(
        "const A = 2 / «TAU»;",
        "unknown constant `TAU`; write `(2 * PI)`",
    );
    super::assert_messages(
        "const A = «sizes::ROD»;",
        &[
            "paths of Rust cannot be seen here; declare `const ROD = ...;` in the mechanism and write `ROD`",
        ],
    );
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
fn a_look_is_told_by_its_words() {
    offered(
        "link a { circle (0, 0) radius 1 «plane 2»; }",
        "a plane is given by two words; write `on plane 2`",
    );
    offered(
        "link a { circle (0, 0) radius 1 on «2»; }",
        "expected `plane` before this number; write `plane 2`",
    );
    offered(
        "link a { circle (0, 0) «1»; }",
        "expected `radius` before this number; write `radius 1`",
    );
    super::assert_messages(
        "link a { circle (0, 0) radius 1 color 3 «plane» 2; }",
        &["`on plane` stands before `color`; swap the two"],
    );
    super::assert_messages(
        "link a { circle (0, 0) radius 1 «colour» 3; }",
        &["write `color` for `colour`"],
    );
}

#[test]
fn a_color_has_a_name_or_a_number() {
    let choices = "a color is one of paper, ground, blue, orange, teal, red, yellow, purple, green, pink, sky, brown, olive, slate, \
        ink, eye, hatch, steel, or the number of an entry of the palette, from 0 to 255";
    let unknown =
        |name: &str, remedy: &str| format!("there is no color `{name}`{remedy}\n\nnote: {choices}");
    super::assert_messages(
        "link a { circle (0, 0) radius 1 color «Teal»; }",
        &[&unknown("Teal", "; did you mean `teal`?")],
    );
    super::assert_messages(
        "link a { circle (0, 0) radius 1 color «black»; }",
        &[&unknown("black", "")],
    );
    super::assert_messages(
        "link a { circle (0, 0) radius 1 color «\"red\"»; }",
        &[&format!(
            "expected a color's name or number, found `\"red\"`; {choices}"
        )],
    );
    super::assert_messages(
        "link a { circle (0, 0) radius 1 color «light blue»; }",
        &["`light` stands after the color's name; write `blue light`"],
    );
    super::assert_messages(
        "link a { circle (0, 0) radius 1 color «ink» light; circle (0, 0) radius 1 color 4 «dark»; }",
        &[
            "there is no light `ink`; leave `light` out",
            "only a color with a name has a shade; leave this word out, or give the color by its name",
        ],
    );
    super::assert_messages(
        "const red = 300; link a { circle (0, 0) radius 1 color «red»; }",
        &["the number of a color is a whole number from 0 to 255, not 300"],
    );
    super::assert_messages(
        "param red = 5; link a { circle (0, 0) radius 1 color «red»; }",
        &[
            "`red` is a param: it may change while the mechanism runs; only laws, points, lines, joints in a drawing and shapes may \
            depend on one; use a `const` here",
        ],
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
fn an_angle_of_many_radians_is_one_in_degrees() {
    offered(
        "link a { line l = (0, 0) -> «30»; }",
        "`30` is an angle in radians, more than a turn; write `30 deg`\n\nhelp: or give the number a name with `const`, \
         if radians are meant",
    );
}

#[test]
fn a_motor_has_a_statement_of_its_own() {
    let marked = format!("struct M; {CRANK}motor «j, k»;");
    assert_messages_of(
        &marked,
        &["each motor has its own statement; write `motor j; motor k;`"],
    );
    assert_mended(&marked, "j; motor k");
    super::assert_messages(
        "const A = 1«,» B = 2; link a; link b; joint j = revolute(a, b) at (0, 0); start { a near 1«,» b near 2; } effects { velocity«,» acceleration }",
        &[
            "expected `;`, found `,`; write a statement for each",
            "expected `;`, found `,`; end each with `;`",
            "expected `;`, found `,`; end each with `;`",
        ],
    );
}

#[test]
fn words_stand_where_they_belong() {
    offered(
        "«let» x = 3;",
        "numbers are declared by `const`; write `const` for `let`",
    );
    super::assert_messages(
        "«use» std::f64;",
        &["`use` belongs to Rust; write it outside of `mechanism!`"],
    );
    super::assert_messages(
        "«point» p = (0, 0);",
        &["`point` is fixed to a link; write it in the braces of `ground` or of a `link`"],
    );
    super::assert_messages(
        "link a { «joint» j = revolute(ground, a) at (0, 0); }",
        &["`joint` is a statement of its own; write it after the braces of the link"],
    );
}

#[test]
fn an_angle_of_many_radians_is_asked_about() {
    let help = "\n\nhelp: or give the number a name with `const`, if radians are meant";
    for (wrong, offer) in [
        ("60", "60 deg"),
        ("-7.5", "-7.5 deg"),
        ("2 * 30", "(2 * 30) deg"),
    ] {
        let message =
            format!("`{wrong}` is an angle in radians, more than a turn; write `{offer}`{help}");
        offered(&format!("{CRANK}start {{ j = «{wrong}»; }}"), &message);
        offered(&format!("{CRANK}start {{ a near «{wrong}»; }}"), &message);
    }
    let slide = "ground { line l = (0, 0) -> (1, 0); } link a { line l = (0, 0) -> (1, 0); } joint j = prismatic(ground.l, a.l);";
    super::assert_messages(&format!("{slide} motor j; start {{ j = 60; }}"), &[]);
    for right in ["6", "20 * PI", "720 deg", "START"] {
        super::assert_messages(
            &format!("{CRANK}const START = 60; motor j; start {{ j = {right}; }}"),
            &[],
        );
    }
}

#[test]
fn a_range_of_many_radians_is_asked_about() {
    let help = "\n\nhelp: or give the number a name with `const`, if radians are meant";
    for (wrong, offer) in [
        ("0 ..= 90", "0 deg ..= 90 deg"),
        ("-7.5 ..= 3", "-7.5 deg ..= 3 deg"),
        ("0 ..= 2 * 30", "0 deg ..= (2 * 30) deg"),
    ] {
        let message = format!("`{wrong}` is in radians, more than a turn; write `{offer}`{help}");
        offered(&format!("{CRANK}motor j in «{wrong}»;"), &message);
    }
    for right in ["-6 ..= 6", "0 ..= 20 * PI", "0 ..= 720 deg", "0 ..= FAR"] {
        super::assert_messages(&format!("const FAR = 90; {CRANK}motor j in {right};"), &[]);
    }
    let slide = "ground { line l = (0, 0) -> (1, 0); } link a { line l = (0, 0) -> (1, 0); } joint j = prismatic(ground.l, a.l);";
    super::assert_messages(&format!("{slide} motor j in 0 ..= 90;"), &[]);
}

#[test]
fn effects_stand_in_braces_each_with_its_end() {
    let message = |after: &str| format!("expected `;` after `{after}`");
    super::assert_messages(
        "effects { «velocity» acceleration; }",
        &[&message("velocity")],
    );
    super::assert_messages(
        "effects { velocity; «force» dynamics overlay }",
        &[&message("force")],
    );
    super::assert_messages("effects { velocity; acceleration; }", &[]);
    super::assert_messages(
        "effects «velocity»;",
        &["expected `{`, found `velocity`; write `effects { velocity; }`"],
    );
    super::assert_messages("effects «7»;", &["expected `{`, found `7`"]);
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

#[test]
fn a_name_that_two_claim_is_told_once() {
    let second = "there is a link `b` already; choose another name for this joint";
    super::assert_messages(
        "link a; link b; joint «b» = revolute(a, b) at (0, 0); motor b; start { b = 1; b near 0; } spring s = torsional(b) stiffness 1; \
         load l = torque(b); show b;",
        &[second],
    );
    super::assert_messages(
        "link a; joint d = revolute(ground, a) at (0, 0); link «d»; joint e = revolute(a, d) at (1, 0); motor d; start { d near 0; }",
        &["there is a joint `d` already; choose another name for this link"],
    );
}
