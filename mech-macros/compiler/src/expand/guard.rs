//! The macro's guard: what is broken in the compiler itself becomes an error at the mechanism.

use crate::bug::broken_in;
use crate::syntax::{Message, Place};
use proc_macro2::TokenStream;
use quote::quote;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs an expansion of a mechanism. An internal error becomes a compile error at the mechanism, beside a stub of its type.
///
/// The compiler prints no panic that a macro catches, so there is no noise to silence.
pub(crate) fn guarded(
    mechanism: &TokenStream,
    expansion: impl FnOnce() -> TokenStream,
    stub: impl FnOnce() -> TokenStream,
) -> TokenStream {
    caught(expansion).unwrap_or_else(|what| {
        let text =
            format!("internal error: {what}. Please report it, with this text:\n{mechanism}");
        let error = Message::new(Place::of(mechanism), text).to_compile_error();
        // The error above is what counts: if the stub fails too, the user does without it.
        let stub = caught(stub).unwrap_or_default();
        quote!(#error #stub)
    })
}

/// What an expansion gives, or what is broken.
fn caught(expansion: impl FnOnce() -> TokenStream) -> Result<TokenStream, String> {
    // Nothing that the expansion changes is seen by anybody else.
    catch_unwind(AssertUnwindSafe(expansion)).map_err(|panic| broken_in(panic.as_ref()))
}

#[cfg(test)]
mod tests;
