//! Texts as they stand: their words, and changes of them.

mod draft;
pub(crate) mod keyword;
mod masked;
mod number;
mod places;
mod quoted;

use draft::Draft;
pub use draft::Replacement;
pub(crate) use draft::written;
pub(crate) use masked::masked;
pub(crate) use mech_compiler::syntax::lexer::{Kind, Lexeme, Lexer, is_of_word};
pub(crate) use number::rounded;
pub(crate) use number::{shortest, written_like};
pub(crate) use places::TokenPlaces;
pub(crate) use quoted::quoted;
