//! The procedural macro behind `mech_runtime::mechanism!`: a shim over `mech_compiler`, where everything happens.

use proc_macro::TokenStream;

/// Expands a mechanism. Called by `mech_runtime::mechanism!`, which hands over the path of the runtime crate first,
/// so that a renamed dependency works.
#[proc_macro]
pub fn mechanism(input: TokenStream) -> TokenStream {
    mech_compiler::expand(input.into()).into()
}

/// Keeps a part for mechanisms elsewhere. Called by `mech_runtime::mechanism_part!`.
#[proc_macro]
pub fn mechanism_part(input: TokenStream) -> TokenStream {
    mech_compiler::expand_part(&input.into()).into()
}
