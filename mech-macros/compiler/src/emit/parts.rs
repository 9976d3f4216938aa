//! The parts of the generated code, as each file of this room adds to them.

use proc_macro2::TokenStream;

/// Parts of the generated code.
#[derive(Default)]
pub(super) struct Parts {
    /// Fields of the struct.
    pub(super) fields: TokenStream,
    /// The same fields with their values at the start.
    pub(super) start: TokenStream,
    /// Constants for the module `known`.
    pub(super) known: TokenStream,
    /// Associated constants and methods of the struct.
    pub(super) methods: TokenStream,
    /// Items of the implementation of `Mechanism`.
    pub(super) trait_items: TokenStream,
    /// Modules with the functions of a program.
    pub(super) modules: TokenStream,
}

impl Parts {
    /// Associated constants and methods alone.
    pub(super) fn methods(methods: TokenStream) -> Self {
        Self { methods, ..Self::default() }
    }
}

impl FromIterator<Parts> for Parts {
    fn from_iter<I: IntoIterator<Item = Self>>(all: I) -> Self {
        let mut sum = Self::default();
        for parts in all {
            sum.fields.extend(parts.fields);
            sum.start.extend(parts.start);
            sum.known.extend(parts.known);
            sum.methods.extend(parts.methods);
            sum.trait_items.extend(parts.trait_items);
            sum.modules.extend(parts.modules);
        }
        sum
    }
}
