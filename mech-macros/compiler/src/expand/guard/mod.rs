//! The guard of the macro: a broken invariant of the compiler becomes an error at the mechanism.

use crate::bug::catch;
use crate::syntax::{Message, Place};
use proc_macro2::TokenStream;
use quote::quote;

/// Runs an expansion of a mechanism. A broken invariant becomes a compile error at the mechanism, beside a stub of its type.
///
/// The compiler prints no panic that a macro catches, so there is no noise to silence.
pub(crate) fn guard(
    mechanism: &TokenStream,
    expansion: impl FnOnce() -> TokenStream,
    stub: impl FnOnce() -> TokenStream,
) -> TokenStream {
    catch(expansion).unwrap_or_else(|what| {
        let text =
            format!("internal error: {what}. Please report it, with this text:\n{mechanism}");
        beside_stub(&Message::new(Place::of(mechanism), text), stub)
    })
}

/// An error beside a stub of the mechanism's type.
pub(super) fn beside_stub(message: &Message, stub: impl FnOnce() -> TokenStream) -> TokenStream {
    let error = message.to_compile_error();
    // The error is what counts: if the stub fails too, the user does without it.
    let stub = catch(stub).unwrap_or_default();
    quote!(#error #stub)
}

#[cfg(test)]
mod tests;
