//! The graphs of a mechanism, which the compiler finds in its source.

use mech_compiler::graphs::{Graph, kinematic, loops};
use mech_compiler::model::Model;
use mech_compiler::{Import, PartText, compile, syntax};
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

/// The source of the parts that mechanisms import.
const PARTS: &str = include_str!("../../../../mech-runtime/src/parts.rs");

/// The mechanism with this name, which a `mechanism!` of this Rust source declares.
fn model(source: &str, name: &str) -> Option<Model> {
    let mut models = calls(source.parse().ok()?, "mechanism").into_iter();
    models.find_map(|declaration| {
        let text = Import::write_out(declaration, part).ok()?;
        Some(syntax::parse(text).model).filter(|model| model.name == name)
    })
}

/// The text of an imported part.
fn part(import: &Import) -> Option<TokenStream> {
    let name = import.name()?;
    let mut parts = calls(PARTS.parse().ok()?, "mechanism_part").into_iter();
    parts.find_map(|part| {
        let part = PartText::read(&part).ok()?;
        (part.name == name).then_some(part.body)
    })
}

/// The tokens in the brackets of each call of a macro.
fn calls(source: TokenStream, name: &str) -> Vec<TokenStream> {
    let trees: Vec<_> = source.into_iter().collect();
    let call = |trees: &[TokenTree]| match trees {
        [
            TokenTree::Ident(ident),
            TokenTree::Punct(mark),
            TokenTree::Group(group),
        ] if ident == name && mark.as_char() == '!' => Some(group.stream()),
        _ => None,
    };
    trees.windows(3).filter_map(call).collect()
}
