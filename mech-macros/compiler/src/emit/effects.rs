//! What the struct of a mechanism has more for its effects.

use super::added::Added;
use super::{forces, overlay, params, rates, timing, traces};
use crate::compiled::Compiled;
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
        (&rates.standstill, &record),
    );
    let moved = rates.and(forces);
    let laws = timing::added(
        krate,
        model,
        compiled,
        visibility,
        (&moved.standstill, &record),
    );
    let overlay = overlay::added(model, compiled, visibility);
    let standstill = &moved.standstill;
    let end = quote!(#standstill #record);
    let params = params::added(krate, places, model, compiled, visibility, &end);
    moved.and(laws).and(traces).and(overlay).and(params)
}
