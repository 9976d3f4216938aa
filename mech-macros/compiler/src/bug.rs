//! Internal errors: what can only be wrong with the compiler itself.

use crate::syntax::{Message, Place};
use proc_macro2::TokenStream;
use quote::quote;
use std::any::Any;
use std::fmt::Arguments;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What an internal error begins with, wherever it is read.
const BEFORE: &str = "internal error in mech: ";
/// What it ends with.
const AFTER: &str = "; please report this with the mechanism";

/// Ends the analysis, because an invariant of our own is broken and any answer might be wrong.
///
/// The macro turns this into an error at the mechanism, with its text.
macro_rules! bug {
    ($($what:tt)+) => {
        $crate::bug::broken(::std::format_args!($($what)+))
    };
}
pub(crate) use bug;

/// Panics with a message that names itself.
#[cold]
#[track_caller]
pub(crate) fn broken(what: Arguments<'_>) -> ! {
    panic!("{BEFORE}{what}{AFTER}")
}

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
    catch_unwind(AssertUnwindSafe(expansion)).map_err(|panic| what(panic.as_ref()))
}

/// What a panic says is broken. One that is not from [`bug!`], as of an index beyond its list, says it in its own words.
fn what(panic: &(dyn Any + Send)) -> String {
    let text = match (panic.downcast_ref::<String>(), panic.downcast_ref::<&str>()) {
        (Some(text), _) => text.as_str(),
        (None, Some(text)) => text,
        (None, None) => "a panic that says nothing",
    };
    let named = text.strip_prefix(BEFORE);
    let named = named.and_then(|text| text.strip_suffix(AFTER));
    named.unwrap_or(text).to_owned()
}

#[cfg(test)]
mod tests;
