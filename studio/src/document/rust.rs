//! A mechanism as Rust.

/// The inside of a mechanism, by its lines, in a file of Rust: a call of `mechanism!`.
pub(crate) fn in_rust<'t>(inside: impl IntoIterator<Item = &'t str>) -> String {
    let inside = inside.into_iter().map(|line| match line {
        "" => "\n".to_owned(),
        line => format!("    {line}\n"),
    });
    let inside: String = inside.collect();
    format!("use mech_runtime::mechanism;\n\nmechanism! {{\n{inside}}}\n")
}
