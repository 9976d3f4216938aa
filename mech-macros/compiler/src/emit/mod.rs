//! Generated code: the struct of a mechanism, its methods, and the functions of its programs.
//!
//! `items` and `stub` stand above all other files. `emitter` reads the mechanism for them, and `parts` is what each adds. `step` writes
//! the functions of programs.

mod accessors;
mod advance;
mod coordinate;
mod costs;
mod drawing;
mod emitter;
mod expression;
mod forces;
mod instance_methods;
mod inverse;
mod inverse_rates;
mod items;
mod joints;
mod known;
mod least;
mod led;
mod limits;
mod many;
mod merge;
mod method;
mod module;
mod moves;
mod overlay;
mod params;
mod rate_accessors;
mod rates;
mod sensitivity;
mod shapes;
mod step;
mod stub;
mod timing;
mod tokens;
mod traces;
mod views;

use proc_macro2::TokenStream;

/// From so many entries on a constant is written as a table, which the Rust compiler reads sooner; fewer stand one by one, as a reader
/// likes them.
const MANY: usize = 64;

pub(crate) use items::items;
pub(crate) use stub::stub;

/// Parts of the generated code.
#[derive(Default)]
struct Parts {
    /// Fields of the struct.
    fields: TokenStream,
    /// The same fields with their values at the start.
    start: TokenStream,
    /// Constants for the module `known`.
    known: TokenStream,
    /// Associated constants and methods of the struct.
    methods: TokenStream,
    /// Items of the implementation of `Mechanism`.
    trait_items: TokenStream,
    /// Modules with the functions of a program.
    modules: TokenStream,
}

impl Parts {
    /// Associated constants and methods alone.
    fn methods(methods: TokenStream) -> Self {
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
