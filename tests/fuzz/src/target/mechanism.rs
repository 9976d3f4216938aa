//! The macro: what it makes of any tokens is Rust, or says what is wrong at a place.

use crate::finding::Finding;
use mech_compiler::{analyse, expand, expand_part, write};
use proc_macro2::TokenStream;
use quote::quote;

pub(super) fn examine(text: &str) -> Result<bool, Finding> {
    // Tokens keep the whole text for their places.
    proc_macro2::extra::invalidate_current_thread_spans();
    let Ok(tokens) = text.parse::<TokenStream>() else {
        return Ok(false);
    };
    let krate = quote!(::mech_runtime);
    // What is taken from elsewhere is expanded in two steps.
    is_rust(expand_part(&tokens))?;
    if mech_compiler::Import::first(&tokens).is_some() {
        is_rust(expand(quote!(#krate; #tokens)))?;
        return Ok(false);
    }
    let analysis = analyse(tokens);
    if let Ok(compiled) = &analysis.result {
        let plan = compiled.plan.display(&analysis.parsed.model).to_string();
        let program = compiled.program.to_string();
        if plan.is_empty() || program.is_empty() {
            return Err(Finding::new("a plan or a program is shown as nothing"));
        }
    }
    is_rust(write(&krate, &analysis))?;
    Ok(analysis.parsed.errors.is_empty())
}

fn is_rust(tokens: TokenStream) -> Result<(), Finding> {
    match syn::parse2::<syn::File>(tokens) {
        Ok(_) => Ok(()),
        Err(error) => Err(Finding::new(format!("what is written is no Rust: {error}"))),
    }
}
