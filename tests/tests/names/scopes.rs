//! What else a crate may have by a name, beside a mechanism.

use super::crates::Line;
use super::subjects::SUBJECTS;
use super::{invocation, left};

/// Kinds of items that may have one name together: what they are, and what declares items of all these names.
type Kinds = (&'static str, fn(&[&str]) -> String);

fn each(names: &[&str], declare: impl Fn(&str) -> String) -> String {
    names.iter().map(|name| declare(name)).collect()
}

const KINDS: &[Kinds] = &[
    ("constants, modules and macros", |names| {
        each(names, |name| {
            format!("const {name}: () = (); mod {name} {{}} macro_rules! {name} {{ () => {{}}; }}")
        })
    }),
    ("statics and types", |names| {
        each(names, |name| format!("static {name}: () = (); type {name} = ();"))
    }),
    ("functions and structs", |names| {
        each(names, |name| format!("fn {name}() {{}} struct {name} {{}}"))
    }),
    ("unit structs", |names| each(names, |name| format!("struct {name};"))),
    ("tuple structs", |names| each(names, |name| format!("struct {name}(u8);"))),
    ("methods that take anything", |names| {
        each(names, |name| {
            format!(
                "trait Any_{name}: Sized {{ fn {name}(self) {{}} }} impl<Anything> Any_{name} for Anything {{}}"
            )
        })
    }),
];

/// What brings variants of these names into scope.
fn variants(names: &[&str]) -> String {
    let names = names.join(", ");
    format!("mod apart {{ pub enum Variants {{ {names} }} }} use apart::Variants::{{{names}}};")
}

/// Every subject beside items of each kind.
pub(crate) fn lines(names: &[String]) -> Vec<Line> {
    let own = |name: &&str| SUBJECTS.iter().all(|subject| !subject.declares(name));
    let names: Vec<&str> = names.iter().map(String::as_str).filter(own).collect();
    let mechanisms: String = SUBJECTS
        .iter()
        .map(|subject| {
            let text = subject.plain();
            if subject.is_wrong() { left(&text) } else { invocation(&text) }
        })
        .collect();
    let mut lines = vec![
        Line::new("variants".to_owned(), format!("{} {mechanisms}", variants(&names))),
        Line::new("no prelude".to_owned(), format!("#![no_implicit_prelude] {mechanisms}")),
    ];
    for (kind, declare) in KINDS {
        let items = declare(&names);
        lines.push(Line::new((*kind).to_owned(), format!("{items} {mechanisms}")));
        lines.push(Line::new(
            format!("{kind} in a function"),
            format!("fn function() {{ {items} {mechanisms} }}"),
        ));
    }
    lines
}
