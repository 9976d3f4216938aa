//! The graphs of a mechanism, which the compiler finds in its source.

use mech_compiler::graphs::{Graph, kinematic, loops};
use mech_compiler::model::Model;
use mech_compiler::{Import, PartText, compile, macro_calls, syntax};
use mech_runtime::parts;

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

/// The mechanism with this name, which a `mechanism!` of this Rust source declares. Its parts are those of the runtime.
fn model(source: &str, name: &str) -> Option<Model> {
    let mut declarations = macro_calls(source.parse().ok()?, "mechanism").into_iter();
    let part = |import: &Import| Some(PartText::find(parts::SOURCE, &import.name()?)?.body);
    declarations.find_map(|declaration| {
        let text = Import::write_out(declaration, part).ok()?;
        Some(syntax::parse(text).model).filter(|model| model.name == name)
    })
}
