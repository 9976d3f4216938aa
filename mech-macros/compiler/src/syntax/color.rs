//! Colours, for messages about those who name them.

use mech_core::colors::NAMED;

/// Says how to write a colour that was given by this name.
pub(super) fn advice_for(name: &str) -> String {
    let mut known = NAMED.iter();
    let known = known.find(|(known, _)| known.eq_ignore_ascii_case(name));
    let beginning = match known {
        Some((_, number)) => {
            format!("a color is given by its number; write `{number}` for `{name}`")
        }
        None => format!("a color is given by its number, and no palette names one `{name}`"),
    };
    format!("{beginning}\n\nnote: {}", choices())
}

/// Which colours there are.
pub(super) fn choices() -> String {
    let table: Vec<_> = NAMED
        .iter()
        .map(|(name, number)| format!("{number} {name}"))
        .collect();
    format!("a color is a number from 0 to 255: {}", table.join(", "))
}
