//! Texts as they stand: their words and numbers, and changes of them.

mod draft;
pub(crate) mod keyword;
mod masked;
mod places;

use draft::Draft;
pub use draft::Replacement;
pub(crate) use draft::written;
pub(crate) use masked::masked;
pub(crate) use mech_compiler::syntax::lexer::{Kind, Lexeme, Lexer, is_of_word};
pub(crate) use places::TokenPlaces;

/// Names in backquotes, one after the other; `none` if there are none.
pub(crate) fn quoted<N: AsRef<str>>(names: impl IntoIterator<Item = N>) -> String {
    let names = names.into_iter();
    let names: Vec<String> = names.map(|name| format!("`{}`", name.as_ref())).collect();
    if names.is_empty() { "none".to_owned() } else { names.join(", ") }
}

/// The bracket that closes an opening one; none if nothing does.
pub(crate) fn closing(lexemes: &[Lexeme], open: usize) -> Option<usize> {
    let mut depth = 0_usize;
    (open..lexemes.len()).find(|&next| {
        match lexemes[next].kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            Kind::Word | Kind::Mark => {}
        }
        depth == 0
    })
}

/// A number, with a decimal point where the one before it has one.
pub(crate) fn written_like(value: f64, old: &str) -> String {
    // Zero has no sign.
    let value = value + 0.0;
    let is_plain = value == 0.0 || (1e-5..1e15).contains(&value.abs());
    if is_plain && !old.contains(['.', 'e']) { format!("{value}") } else { format!("{value:?}") }
}

/// The shortest number that is no farther from this one than the tolerance.
pub(crate) fn shortest(value: f64, tolerance: f64) -> String {
    written_like(rounded(value, tolerance), "")
}

/// The number with the fewest decimal places that is no farther from this one than the tolerance.
pub(crate) fn rounded(value: f64, tolerance: f64) -> f64 {
    let is_near = |short: &f64| (short - value).abs() <= tolerance;
    let found = (0..=15).find_map(|places| {
        let short = format!("{value:.places$}").parse().ok();
        short.filter(is_near)
    });
    // Zero has no sign.
    found.unwrap_or(value) + 0.0
}

#[cfg(test)]
mod tests {
    use super::shortest;

    #[test]
    fn numbers_have_no_digits_that_nobody_needs() {
        assert_eq!(shortest(5.000_000_054, 1e-7), "5");
        assert_eq!(shortest(-0.000_000_01, 1e-7), "0");
        assert_eq!(shortest(0.1 + 0.2, 1e-9), "0.3");
        assert_eq!(shortest(0.1 + 0.2, 0.0), "0.30000000000000004");
        assert_eq!(shortest(1234.5678, 1e-3), "1234.568");
        assert_eq!(shortest(2.5e-7, 0.0), "2.5e-7");
    }
}
