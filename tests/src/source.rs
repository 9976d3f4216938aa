//! The mechanisms in a source file, read by the compiler itself.

use mech_compiler::model::Model;
use mech_compiler::syntax::parse;
use mech_compiler::{Compiled, compile, reporter};
use proc_macro2::TokenStream;
use syn::visit::Visit;

/// Every `mechanism!` of a source file, in order.
///
/// # Panics
/// If the file is not Rust or a mechanism in it has errors: the caller has just compiled it.
#[must_use]
pub fn mechanisms(source: &str) -> Vec<(Model, Compiled)> {
    bodies(source).into_iter().map(read).collect()
}

/// The text of every `mechanism!` of a source file, in order.
///
/// # Panics
/// If the file is not Rust: the caller has just compiled it.
#[must_use]
pub fn bodies(source: &str) -> Vec<TokenStream> {
    struct Found(Vec<TokenStream>);
    impl<'ast> Visit<'ast> for Found {
        fn visit_macro(&mut self, called: &'ast syn::Macro) {
            if called.path.is_ident("mechanism") {
                self.0.push(called.tokens.clone());
            }
        }
    }
    let file = syn::parse_file(source).expect("the file is Rust");
    let mut found = Found(Vec::new());
    found.visit_file(&file);
    found.0
}

fn read(text: TokenStream) -> (Model, Compiled) {
    let parsed = parse(text);
    let errors: Vec<&str> = parsed
        .errors
        .iter()
        .map(|error| error.text.as_str())
        .collect();
    assert!(errors.is_empty(), "{errors:?}");
    let compiled = compile(&parsed.model).unwrap_or_else(|wrong| {
        let messages: Vec<String> = wrong
            .iter()
            .map(|wrong| reporter::text(wrong, &parsed.model))
            .collect();
        panic!("{}", messages.join("; "))
    });
    (parsed.model, compiled)
}
