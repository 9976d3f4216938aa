//! The graphs of a mechanism, which the compiler finds in its source.

use mech_compiler::graphs::{Graph, kinematic, loops};
use mech_compiler::model::Model;
use mech_compiler::{compile, syntax};
use proc_macro2::{TokenStream, TokenTree};

/// The graphs of a mechanism: its links, and the order in which its loops are solved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Graphs {
    /// Its links and the joints between them.
    pub links: Graph,
    /// Its loops, and the motors and loops that they need.
    pub loops: Graph,
}

impl Graphs {
    /// The graphs of the mechanism with this name, which a `mechanism!` of this Rust source declares.
    #[must_use]
    pub fn find(source: &str, name: &str) -> Option<Self> {
        let model = model(source, name)?;
        let compiled = compile(&model).ok()?;
        Some(Self {
            links: kinematic(&model, &compiled.structure),
            loops: loops(&model, &compiled.plan),
        })
    }
}

/// The mechanism with this name, which a `mechanism!` of this Rust source declares.
fn model(source: &str, name: &str) -> Option<Model> {
    let mut models = declarations(source.parse().ok()?)
        .into_iter()
        .map(|declaration| syntax::parse(declaration).model);
    models.find(|model| model.name == name)
}

/// The tokens in the brackets of each `mechanism!`.
fn declarations(source: TokenStream) -> Vec<TokenStream> {
    let trees: Vec<_> = source.into_iter().collect();
    let declaration = |trees: &[TokenTree]| match trees {
        [
            TokenTree::Ident(ident),
            TokenTree::Punct(mark),
            TokenTree::Group(group),
        ] if ident == "mechanism" && mark.as_char() == '!' => Some(group.stream()),
        _ => None,
    };
    trees.windows(3).filter_map(declaration).collect()
}
