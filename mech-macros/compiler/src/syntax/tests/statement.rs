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
}
