//! What the struct of a mechanism has more for its effects.

use super::overlay::OverlayItems;
use super::rates::RateItems;
use super::traces::{TraceItems, painting};
use crate::model::Model;
use crate::program::Program;
use crate::structure::Structure;
use crate::syntax::Places;
use proc_macro2::TokenStream;

/// The parts of the generated code that effects add; of each nothing without them, but for the painting.
pub(super) struct EffectItems {
    /// Fields of the struct.
    pub(super) fields: TokenStream,
    /// The same in its constructor.
    pub(super) initial: TokenStream,
    /// What a move without rates ends with.
    pub(super) end: TokenStream,
    /// What a move of another instance begins with, and what it ends with.
    pub(super) instance: [TokenStream; 2],
    /// Imports of the generated code, tables and functions.
    pub(super) imports: TokenStream,
    /// Methods.
    pub(super) methods: TokenStream,
    /// Methods of the trait.
    pub(super) trait_methods: TokenStream,
    /// How everything is painted.
    pub(super) painting: TokenStream,
    /// The step that goes on to rates.
    pub(super) steps: TokenStream,
}

impl EffectItems {
    /// What the effects of a mechanism add to it.
    pub(super) fn new(
        krate: &TokenStream,
        places: &Places,
        model: &Model,
        structure: &Structure,
        (program, moving): (&Program, Option<&Program>),
        visibility: &syn::Visibility,
    ) -> Self {
        let traces = TraceItems::new(krate, places, model, program, visibility);
        let record = &traces.record;
        let rates = RateItems::new(krate, places, model, program, moving, visibility, record);
        let overlay = OverlayItems::new(krate, model, structure, program, visibility);
        let all = |parts: [&TokenStream; 3]| parts.into_iter().cloned().collect();
        let none = &TokenStream::new();
        Self {
            fields: all([&rates.fields, &traces.fields, none]),
            initial: all([&rates.at_rest, &traces.empty, none]),
            end: all([&rates.rest, &traces.record, none]),
            instance: [rates.instance_rest, traces.instance_record],
            imports: all([&rates.imports, &traces.recording, &overlay.tables]),
            methods: all([&rates.methods, &traces.methods, &overlay.methods]),
            trait_methods: traces.trait_methods,
            painting: painting(places, model, program),
            steps: rates.steps,
        }
    }
}
