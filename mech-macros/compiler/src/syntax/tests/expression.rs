//! Numbers.

use super::good;
use std::f64::consts::PI;

fn value(text: &str) -> f64 {
    let text = format!(
        "struct M; const A = 3; const B_2 = A + 1; const X = {text}; ground {{ point p = (X, 0); }}"
    );
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
fn deep_brackets_are_read() {
    assert_eq!(value(&format!("{}7{}", "(".repeat(63), ")".repeat(63))), 7.0);
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
