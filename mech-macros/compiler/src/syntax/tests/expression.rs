//! Numbers.

use super::{assert_messages, good, unseen};
use std::f64::consts::PI;

fn value(text: &str) -> f64 {
    let text =
        format!("struct M; const A = 3; const B_2 = A + 1; ground {{ point p = ({text}, 0); }}");
    good(&text).model.axes[0].at[0]
}

#[test]
fn numbers_are_computed() {
    for (text, expected) in [
        ("1", 1.0),
        ("1_000.5", 1000.5),
        ("2.", 2.0),
        ("1e-3", 1e-3),
        ("0x1f", 31.0),
        ("1 - 2 - 3", -4.0),
        ("8 / 2 / 2 * 3", 6.0),
        ("1 + 2 * 3", 7.0),
        ("(1 + 2) * 3", 9.0),
        ("-(-1)", 1.0),
        ("--1", 1.0),
        ("---1", -1.0),
        ("2 * -3", -6.0),
        ("A * B_2", 12.0),
        ("PI", PI),
        ("sqrt(16)", 4.0),
        ("sin(0)", 0.0),
        ("cos(0) + tan(0)", 1.0),
        ("180 deg", PI),
        ("90deg", PI / 2.0),
        ("1.5deg * 2", 3_f64.to_radians()),
        ("-90 deg", -PI / 2.0),
        ("(45 + 45) deg", PI / 2.0),
        ("A deg", 3_f64.to_radians()),
        ("2 * 90 deg", PI),
        ("sqrt(8100) deg", PI / 2.0),
        ("atan(1)", PI / 4.0),
        ("exp(0) + abs(-A)", 4.0),
        ("min(A, B_2) - max(-1, -2,)", 4.0),
        ("asin(1) + acos(-1)", 1.5 * PI),
        ("atan2(1, -1)", 0.75 * PI),
        ("hypot(A, -B_2)", 5.0),
        ("floor(-1.5) + floor(2)", 0.0),
        ("mod(-1, A)", 2.0),
        ("mod(7, -B_2)", -1.0),
        ("sign(-A) + sign(0)", -1.0),
    ] {
        assert_eq!(value(text), expected, "{text}");
    }
}

#[test]
fn long_chains_and_many_signs_do_no_harm() {
    assert_eq!(value(&vec!["1"; 20_000].join(" + ")), 20_000.0);
    assert_eq!(value(&format!("{} 1", "- ".repeat(20_001))), -1.0);
}

#[test]
fn deep_brackets_are_too_many() {
    let (open, close) = ("(".repeat(64), ")".repeat(64));
    assert_eq!(
        value(&format!("{}7{}", "(".repeat(63), ")".repeat(63))),
        7.0
    );
    let message = "too many brackets in one another; give a part of it a name with `const`";
    assert_messages(&format!("const A = {open}«1»{close};"), &[message]);
}

#[test]
fn a_number_must_be_finite() {
    let large = "this number is too large; the largest is about 1.8e308";
    assert_messages("const A = 1 + «1e999»;", &[large]);
    assert_messages("const A = 2 + «1e300 * 1e300» * 0;", &[large]);
    assert_messages("const A = 1 + 3 * (2 + «1 / 0»);", &["division by zero"]);
    assert_messages(
        "const Z = 1 - 1; const A = «2 * 3 / Z» + 1;",
        &["division by zero"],
    );
    assert_messages("const A = «exp(1000)»;", &[large]);
    assert_messages(
        "const A = 1 + «sqrt(-1)»;",
        &["-1 has no square root; it is negative"],
    );
    assert_messages(
        "const A = «asin(2)»; const B = «acos(-1.5)»; const C = «atan2(0, 0)»; const D = «mod(1, 0)»;",
        &[
            "2 is the sine of no angle; sines are from -1 to 1",
            "-1.5 is the cosine of no angle; cosines are from -1 to 1",
            "`atan2(0, 0)` has no value; a vector without length has no direction",
            "division by zero",
        ],
    );
}

#[test]
fn all_errors_of_a_number_are_reported() {
    assert_messages(
        "const A = «B» + 1 / «C» - sin(«D»);",
        &[
            &unseen("B", "there is only `PI`"),
            &unseen("C", "there is only `PI`"),
            &unseen("D", "there is only `PI`"),
        ],
    );
}

#[test]
fn units_are_degrees_or_none() {
    let unknown = |unit| {
        format!(
            "unknown unit `{unit}`; lengths and angles in radians have none, degrees have `deg`"
        )
    };
    assert_messages("const A = «90parsec»;", &[&unknown("parsec")]);
    assert_messages(
        "const A = 90deg «deg»;",
        &["this number is in degrees already; leave one `deg` out"],
    );
    assert_messages("const A = 90 «parsec»;", &["expected `;`, found `parsec`"]);
}

#[test]
fn constants_are_declared_before_use() {
    assert_messages(
        "const A = «B»; const B = 1;",
        &["constant `B` is declared further down; move its line up"],
    );
    assert_messages(
        "const A = «A» + 1;",
        &["constant `A` cannot be computed from itself"],
    );
    assert_messages(
        "const THROW = 1; const A = «THROV»;",
        &["unknown constant `THROV`; did you mean `THROW`?"],
    );
    assert_messages(
        "const A = 1; const «A» = 2;",
        &["there is a constant `A` already; choose another name"],
    );
    assert_messages(
        "const «PI» = 3;",
        &["`PI` belongs to the language; choose another name"],
    );
}

#[test]
fn whoever_uses_a_bad_constant_is_not_to_blame() {
    assert_messages(
        "const A = «1 / 0»; const B = A; link l { point p = (A, B); }",
        &["division by zero"],
    );
    assert_messages(
        "const A = «;» const B = A;",
        &["expected a number, found `;`"],
    );
    assert_messages(
        "param A = «1 / 0»; const B = A; link l { point p = (A, B); }",
        &["division by zero"],
    );
}

#[test]
fn what_is_no_number_is_reported() {
    assert_messages(
        "const A = «\"one\"»;",
        &["expected a number, found `\"one\"`"],
    );
    assert_messages("const A = «true»;", &["expected a number, found `true`"]);
    assert_messages("const A = «[»1];", &["expected a number, found `[`"]);
    assert_messages("const A = 1 + «;»", &["expected a number, found `;`"]);
    assert_messages("const A = (1 + «)»;", &["expected a number"]);
    assert_messages(
        "const A = «sqr»(2);",
        &["unknown function `sqr`; did you mean `sqrt`?"],
    );
    assert_messages(
        "const A = «log»(2);",
        &[
            "unknown function `log`; there are `sqrt`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`, `exp`, `abs`, `floor`, `sign`, `atan2`, `hypot`, `min`, `max`, `mod`",
        ],
    );
    assert_messages("const A = sin(1 «2»);", &["expected `)`, found `2`"]);
    assert_messages("const A = 2 «PI»;", &["expected `;`, found `PI`"]);
}

#[test]
fn what_a_macro_stands_in_is_one_number() {
    use proc_macro2::{Delimiter, Group, TokenStream};
    let inner: TokenStream = "1 + 2".parse().expect("tokens");
    let group = Group::new(Delimiter::None, inner);
    let text = quote::quote!(struct M; ground { point p = (#group * 2, 0); });
    let parsed = crate::syntax::parse(text);
    assert!(parsed.errors.is_empty());
    assert_eq!(parsed.model.axes[0].at[0], 6.0);
}
