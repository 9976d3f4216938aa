//! Texts as they stand: words, statements, and changes of them.

mod draft;
mod lexer;
mod number;
mod quoted;
mod statement;

pub use draft::Replacement;
pub(crate) use draft::{Draft, written};
pub(crate) use lexer::{Kind, Lexeme, Lexer, is_of_word};
pub(crate) use number::rounded;
pub(crate) use number::{shortest, written_like};
pub(crate) use quoted::quoted;
pub(crate) use statement::{Statement, statements};
