use super::{calls, word_after};

fn bodies<'t>(text: &'t str) -> Vec<Option<&'t str>> {
    let calls = calls(text, &["mechanism"]);
    let body = |call: super::Call<'t>| call.body.map(|body| &text[body]);
    calls.into_iter().map(body).collect()
}

#[test]
fn calls_with_any_brackets_and_paths() {
    let text = "mechanism! { a } x::mechanism!(b); fn f() { mechanism ! /* here */ [c]; }";
    assert_eq!(bodies(text), [Some(" a "), Some("b"), Some("c")]);
    let whole = |text: &str| text[calls(text, &["mechanism"])[0].whole.clone()].to_owned();
    assert_eq!(whole("use x; a::b::mechanism! { c } d"), "a::b::mechanism! { c }");
}

#[test]
fn what_is_no_call() {
    for text in [
        "// mechanism! { a }",
        "/* /* */ mechanism! { a } */",
        "\"mechanism! { a }\"",
        "r#\"mechanism! { a } \" \"#",
        "br\"mechanism! { a }\"",
        "macro_rules! m { () => { mechanism! { a } } }",
        "my_mechanism! { a }",
        "mechanism { a }",
        "mechanism != { a }",
    ] {
        assert_eq!(bodies(text), [None; 0], "{text}");
    }
}

#[test]
fn files_that_are_no_rust() {
    for text in [
        "' mechanism! { a }",
        "it's so: mechanism! { a }",
        "} ) ] mechanism! { a }",
        "\" mechanism! { a }",
        "/* mechanism! { a }",
        "fn f<'a>(x: &'a str, y: char) { y == '\\''; mechanism! { a } }",
        "r#type mechanism! { a }",
        "'\\u{1F600}' '\"' mechanism! { a }",
    ] {
        assert_eq!(bodies(text), [Some(" a ")], "{text}");
    }
}

#[test]
fn brackets_that_are_not_closed() {
    assert_eq!(bodies("mechanism! { a ( } mechanism! { b }"), [Some(" a ( "), Some(" b ")]);
    assert_eq!(bodies("mechanism! { a"), [None]);
    assert_eq!(bodies("mechanism! { a mechanism! { b"), [None]);
    let noise = "mechanism! { ( ] } ".repeat(1 << 16);
    assert_eq!(bodies(&noise).len(), 1 << 16);
}

#[test]
fn the_name_of_the_type() {
    assert_eq!(word_after("/// struct A\n pub struct B: f32;", "struct"), Some("B"));
    assert_eq!(word_after("part P() { struct A; }", "struct"), None);
    assert_eq!(word_after("struct ;", "struct"), None);
}
