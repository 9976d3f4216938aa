//! The mechanisms in a source file, read by the compiler itself.

use mech_compiler::model::Model;
use mech_compiler::syntax::{Parsed, parse};
use mech_compiler::{Compiled, compile, reporter};
use mech_runtime::Mechanism;
use proc_macro2::{TokenStream, TokenTree};

/// Every `mechanism!` of a source file, in order.
///
/// # Panics
/// If the file is not Rust or a mechanism in it has errors: the caller has just compiled it.
#[must_use]
pub fn mechanisms(source: &str) -> Vec<(Model, Compiled)> {
    bodies(source).into_iter().map(compiled).collect()
}

/// The mechanism in a source file that became this type.
///
/// # Panics
/// If there is none, or as [`mechanisms`].
#[must_use]
pub fn mechanism_of<M: Mechanism>(source: &str) -> (Model, Compiled) {
    let found = mechanisms(source).into_iter().find(|(model, _)| model.name == M::NAME);
    found.expect("the source declares it")
}

/// Every `mechanism!` of a source file, in order, without compiling it.
///
/// # Panics
/// If the file is not Rust, or there is an error in the text of a mechanism.
#[must_use]
pub fn models(source: &str) -> Vec<Model> {
    let bodies = bodies(source).into_iter();
    bodies.map(|body| read(body).model).collect()
}

/// The text of every `mechanism!` of a source file, in order; or the text, if the file is that of a mechanism.
///
/// # Panics
/// If the file is neither Rust nor of a mechanism: the caller has just compiled it.
#[must_use]
pub fn bodies(source: &str) -> Vec<TokenStream> {
    let tokens: TokenStream = source.parse().expect("tokens");
    if !source.contains("mechanism!") {
        return vec![tokens];
    }
    let mut found = Vec::new();
    collect(tokens, &mut found);
    found
}

fn collect(tokens: TokenStream, found: &mut Vec<TokenStream>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    for (place, tree) in trees.iter().enumerate() {
        let TokenTree::Group(group) = tree else {
            continue;
        };
        match &trees[..place] {
            [.., TokenTree::Ident(name), TokenTree::Punct(mark)] if mark.as_char() == '!' => {
                if name == "mechanism" {
                    found.push(group.stream());
                }
            }
            _ => collect(group.stream(), found),
        }
    }
}

/// The mechanism that a text declares.
///
/// # Panics
/// If there is an error in the text itself.
#[must_use]
pub fn model(text: &str) -> Model {
    parsed(text).model
}

/// The same with its text.
///
/// # Panics
/// If there is an error in the text itself.
#[must_use]
pub fn parsed(text: &str) -> Parsed {
    read(text.parse().expect("tokens"))
}

fn read(text: TokenStream) -> Parsed {
    let parsed = parse(text);
    let errors: Vec<_> = parsed.errors.iter().map(|error| &error.text).collect();
    assert!(errors.is_empty(), "{errors:?} in {:?}", parsed.model.name);
    parsed
}

fn compiled(text: TokenStream) -> (Model, Compiled) {
    let model = read(text).model;
    let compiled = compile(&model).unwrap_or_else(|wrong| {
        let messages: Vec<String> =
            wrong.iter().map(|wrong| reporter::text(wrong, &model)).collect();
        panic!("{}", messages.join("; "))
    });
    (model, compiled)
}
