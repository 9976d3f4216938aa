//! Everything that thinks: from the text of a mechanism to the code that moves it.
//!
//! One stair, and data only ever walks down it:
//! `syntax → model → structure → plan → program → emit | evaluate`.

use proc_macro2::TokenStream;

pub mod model;
pub mod syntax;

/// Expands the body of a `mechanism!`. The first token tree is the path of the runtime crate, then a semicolon.
#[must_use]
pub fn expand(input: TokenStream) -> TokenStream {
    input
}
