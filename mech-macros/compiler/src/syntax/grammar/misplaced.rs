//! Words that begin something elsewhere, or in Rust.

use super::beginning::{ITEMS, STATEMENTS};

/// Words of Rust that declare a value.
const VALUES: [&str; 3] = ["let", "var", "static"];
/// Words of Rust that declare something else.
const OF_RUST: [&str; 8] = [
    "fn",
    "use",
    "mod",
    "impl",
    "trait",
    "enum",
    "type",
    "macro_rules",
];

/// Returns the help for a word that begins no statement, but something else.
pub(super) fn as_statement(word: &str) -> Option<String> {
    if VALUES.contains(&word) {
        Some(format!(
            "numbers are declared by `const`; write `const` for `{word}`"
        ))
    } else if OF_RUST.contains(&word) {
        Some(format!(
            "`{word}` belongs to Rust; write it outside of `mechanism!`"
        ))
    } else if ITEMS.contains(&word) {
        Some(format!(
            "`{word}` is fixed to a link; write it in the braces of `ground` or of a `link`"
        ))
    } else {
        None
    }
}

/// Returns the help for a word that begins no item of a link, but something else.
pub(super) fn as_item(word: &str) -> Option<String> {
    STATEMENTS.contains(&word).then(|| {
        format!("`{word}` is a statement of its own; write it after the braces of the link")
    })
}
