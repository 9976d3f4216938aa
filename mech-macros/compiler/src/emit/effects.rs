//! What the struct of a mechanism has more for its effects.

use super::added::Added;
use super::{forces, overlay, params, rates, timing, traces};
use crate::Compiled;
use crate::model::Model;
use crate::syntax::Places;
use proc_macro2::TokenStream;
use quote::quote;

/// What the effects of a mechanism add to it; of each nothing without it.
pub(super) fn added(
    krate: &TokenStream,
    places: &Places,
    model: &Model,
    compiled: &Compiled,
    visibility: &syn::Visibility,
) -> Added {
    let Compiled {
        program, forced, ..
    } = compiled;
    let traces = traces::added(krate, places, model, program, visibility);
    let record = traces.record.clone();
    let rates = rates::added(krate, places, model, compiled, visibility, &record);
    let forces = forces::added(
        krate,
        places,
        model,
        (program, forced),
        visibility,
        (&rates.rest, &record),
    );
    let moved = rates.and(forces);
    let laws = timing::added(krate, model, compiled, visibility, (&moved.rest, &record));
    let overlay = overlay::added(krate, model, compiled, visibility);
    let rest = &moved.rest;
    let end = quote!(#rest #record);
    let params = params::added(krate, places, model, compiled, visibility, &end);
    let shared = Added {
        imports: shared_imports(krate, model, compiled),
        ..Added::default()
    };
    shared
        .and(moved)
        .and(laws)
        .and(traces)
        .and(overlay)
        .and(params)
}

/// What several effects use: those that go on from positions, and params.
fn shared_imports(krate: &TokenStream, model: &Model, compiled: &Compiled) -> TokenStream {
    let goes_on = compiled.moving.is_some() || model.effects.needs_actions();
    if !goes_on && model.params.is_empty() {
        return TokenStream::new();
    }
    quote! {
        #[allow(unused_imports, reason = "which of them a mechanism needs depends on what it is made of")]
        use ::core::iter::Iterator as _;
        #[allow(unused_imports, reason = "which of them a mechanism needs depends on what it is made of")]
        use #krate::generated::{Vector2, Velocity, advance_with, determined, finite, rates_at};
    }
}
