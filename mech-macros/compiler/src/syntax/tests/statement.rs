//! The `struct` line, and statements in general.

use super::{assert_messages, assert_messages_of};

#[test]
fn the_struct_line_comes_first() {
    let missing = "expected `struct Name;` first; it names the type that the mechanism becomes";
    let parsed = assert_messages_of("«link» a;", &[missing]);
    assert!(parsed.header.is_none());
    assert_eq!(parsed.model.links.len(), 2);
    assert_eq!(super::parsed("").errors[0].text, missing);
    let late = "the `struct` line stands before everything else; move it to the top";
    assert!(
        assert_messages_of("link a; pub struct «M»;", &[late])
            .header
            .is_some()
    );
    let parsed = assert_messages_of(
        "struct M; struct «N»;",
        &["a mechanism has one `struct` line; remove this one"],
    );
    assert_eq!(parsed.model.name, "M");
}

#[test]
fn the_struct_line_says_f32_or_f64() {
    let parsed = assert_messages_of(
        "struct M: «f16»; link a;",
        &["a mechanism cannot be computed in `f16`; write `f64` or `f32`"],
    );
    assert!(parsed.header.is_some());
    assert_eq!(parsed.model.links.len(), 2);
    assert_messages_of("struct M: «5»;", &["expected `f64` or `f32`, found `5`"]);
    assert_messages_of(
        "struct M «{»} link a;",
        &["expected `;`, or `: f64` or `: f32`, found `{`"],
    );
    assert_messages_of(
        "struct «fn»; link a;",
        &["`fn` is a keyword of Rust; choose another name"],
    );
    assert_messages_of(
        "pub «enum» M; link a;",
        &["expected `struct`, found `enum`"],
    );
    assert_messages_of("struct «M»", &["expected `;` after `M`"]);
}

#[test]
fn attributes_belong_to_the_struct_line() {
    let parsed = assert_messages_of("#[derive(Hash)] #[allow(dead_code)] struct M;", &[]);
    assert_eq!(parsed.header.expect("a header").attributes.len(), 2);
    let parsed = assert_messages_of(
        "#[derive(«Debug»)] struct M;",
        &["every mechanism is `Debug` already; leave it out"],
    );
    assert!(parsed.header.expect("a header").attributes.is_empty());
    let message =
        "only the `struct` line takes attributes and doc comments; write this as a `//` comment";
    let parsed = assert_messages(
        "«/// The crank.»\nlink a; «#[inline]» link b;",
        &[message, message],
    );
    assert_eq!(parsed.model.links.len(), 3);
    assert_messages("#«foo» link a;", &["expected square brackets"]);
}

#[test]
fn unknown_statements_have_a_remedy() {
    assert_messages(
        "«jiont» d = gear(a, b, 1 : 2); motor d;",
        &["unknown statement `jiont`; did you mean `joint`?"],
    );
    assert_messages(
        "«wind» s;",
        &[
            "unknown statement `wind`; a statement begins with one of `const`, `param`, `ground`, `link`, `joint`, `motor`, \
           `start`, `method`, `accuracy`, `cost`, `at`, `allow`, …",
        ],
    );
    assert_messages("link a { }«;»", &["expected a statement, found `;`"]);
    assert_messages("«5» = 3; link a;", &["expected a statement, found `5`"]);
}

#[test]
fn a_message_about_the_end_points_at_the_end() {
    assert_messages("link a; motor «a»", &["expected `;` after `a`"]);
    assert_messages("lin«k»", &["expected the name of a link"]);
}
