//! The names of colours.

use super::ast::Shade;
use super::spelling;
use mech_core::colors::{NAMED, darker, lighter};

/// Whether a color has this name.
pub(super) fn is_name(name: &str) -> bool {
    NAMED.iter().any(|(known, _)| *known == name)
}

/// The entry of the palette that has this name.
///
/// # Errors
/// Why there is none.
pub(super) fn named(name: &str, shade: Option<Shade>) -> Result<u8, String> {
    let Some(&(_, entry)) = NAMED.iter().find(|(known, _)| *known == name) else {
        return Err(unknown(name));
    };
    let (shaded, word) = match shade {
        None => return Ok(entry),
        Some(Shade::Light) => (lighter(entry), "light"),
        Some(Shade::Dark) => (darker(entry), "dark"),
    };
    if shaded == entry {
        return Err(format!("there is no {word} `{name}`; leave `{word}` out"));
    }
    Ok(shaded)
}

fn unknown(name: &str) -> String {
    let names = NAMED.map(|(name, _)| name);
    let nearest = spelling::nearest(&name.to_lowercase(), &names);
    let remedy = nearest.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
    format!("there is no color `{name}`{remedy}\n\nnote: {}", choices())
}

/// Which colours there are.
pub(super) fn choices() -> String {
    let names = NAMED.map(|(name, _)| name).join(", ");
    format!("a color is one of {names}, or the number of an entry of the palette, from 0 to 255")
}
