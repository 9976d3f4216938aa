//! The entry of the macro: tokens to tokens.

mod guard;
mod import;
#[cfg(test)]
mod tests;

pub use import::{Import, PartText, expand_part, macro_calls};

use crate::analysis::{Analysis, analyse};
use crate::bug::bug;
use crate::emit;
use crate::syntax::{self, Message};
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;

/// Expands the body of a `mechanism!`: the path of the runtime crate, a semicolon, and the text of the mechanism.
#[must_use]
pub fn expand(input: TokenStream) -> TokenStream {
    let (krate, body) = split_crate_path(input);
    if let Some(import) = Import::first(&body) {
        let Some(fault) = import.fault() else {
            return import.call(&krate);
        };
        return guard::beside_stub(&fault, || stub(&krate, without_imports(import)));
    }
    guard::guard(&body, || analyse_and_emit(&krate, body.clone()), || stub(&krate, body.clone()))
}

/// The items of a mechanism, or its errors beside a stub of its type.
fn analyse_and_emit(krate: &TokenStream, body: TokenStream) -> TokenStream {
    write(krate, &analyse(body).prove())
}

/// The macro's output for an analysed text: the code of the mechanism, or its errors beside a stub. `krate` is the path of the runtime
/// crate.
#[must_use]
pub fn write(krate: &TokenStream, analysis: &Analysis) -> TokenStream {
    let Analysis { parsed, result } = analysis;
    let header = parsed.header.as_ref();
    match (header, result) {
        (Some(header), Ok(compiled)) => emit::items(krate, header, parsed, compiled),
        (header, Err(faults)) => {
            let errors = compile_errors(&faults.messages);
            let stub = header.map(|header| emit::stub(krate, header, parsed));
            quote!(#errors #stub)
        }
        (None, Ok(_)) => bug!("a mechanism without a name was compiled"),
    }
}

/// The type of a mechanism with methods that do nothing; no tokens for a text without a header.
fn stub(krate: &TokenStream, body: TokenStream) -> TokenStream {
    let parsed = syntax::parse(body);
    let header = parsed.header.as_ref();
    header.map_or_else(TokenStream::new, |header| emit::stub(krate, header, &parsed))
}

/// Returns a text without an import and the imports after it.
fn without_imports(import: Import) -> TokenStream {
    let mut text = import.others;
    while let Some(next) = Import::first(&text) {
        text = next.others;
    }
    text
}

/// The errors as calls of `compile_error!`.
fn compile_errors(errors: &[Message]) -> TokenStream {
    errors.iter().map(Message::to_compile_error).collect()
}

/// The tokens before the first semicolon, and those after it.
fn split_crate_path(input: TokenStream) -> (TokenStream, TokenStream) {
    let mut trees = input.into_iter();
    let is_end =
        |tree: &TokenTree| matches!(tree, TokenTree::Punct(punct) if punct.as_char() == ';');
    let krate = trees.by_ref().take_while(|tree| !is_end(tree)).collect();
    (krate, trees.collect())
}
