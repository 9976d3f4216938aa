//! Texts as they stand: their words, and changes of them.

mod draft;
pub(crate) mod keyword;
mod masked;
mod number;
mod places;

use draft::Draft;
pub use draft::Replacement;
pub(crate) use draft::written;
pub(crate) use masked::masked;
pub(crate) use mech_compiler::syntax::lexer::{Kind, Lexeme, Lexer, is_of_word};
pub(crate) use number::{rounded, shortest, written_like};
pub(crate) use places::TokenPlaces;

/// Names in backquotes, one after the other; `none` if there are none.
pub(crate) fn quoted<N: AsRef<str>>(names: impl IntoIterator<Item = N>) -> String {
    let names = names.into_iter();
    let names: Vec<String> = names.map(|name| format!("`{}`", name.as_ref())).collect();
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
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
