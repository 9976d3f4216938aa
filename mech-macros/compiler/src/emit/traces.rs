//! The fields and methods of traced points.

use super::Parts;
use super::accessors::NamedPoint;
use super::emitter::Emitter;
use super::tokens::integer;
use crate::model::Trace;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// A field and a method for each trace, and `clear_traces`; nothing without traces.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter { krate, visibility, scalar, model, .. } = emitter;
    if model.traces.is_empty() {
        return Parts::default();
    }
    let scalar_path = emitter.scalar_path();
    let mut parts = Parts::default();
    let mut clears = TokenStream::new();
    for trace in &model.traces {
        let NamedPoint { link_name, name, .. } = NamedPoint::new(model, trace.point);
        let (field, length) = (trace_ident(emitter, trace), integer(trace.length));
        let doc = format!(
            " The last places of point `{link_name}.{name}` in the scene, {length} at most: one for each move."
        );
        let kind = quote!(&Trace<#scalar, #length>);
        parts.fields.extend(quote!(#field: #krate::Trace<#scalar_path, #length>,));
        parts.start.extend(quote!(#field: Trace::new(),));
        clears.extend(quote!(Trace::clear(&mut self.#field);));
        let accessor = emitter.constant_accessor(&field, &doc, &kind, &quote!(&self.#field));
        parts.methods.extend(accessor);
    }
    parts.methods.extend(quote! {
        /// Forgets where the traced points have been.
        #visibility const fn clear_traces(&mut self) {
            #clears
        }
    });
    parts
}

/// The implementation of `Traced`, which stores the places of the traced points; none without traces.
pub(super) fn implementation(emitter: &Emitter<'_>, this: &Ident) -> Option<TokenStream> {
    if emitter.model.traces.is_empty() {
        return None;
    }
    let pushes = emitter.model.traces.iter().map(|trace| {
        let (field, place) = (trace_ident(emitter, trace), emitter.point(trace.point));
        quote!(Trace::push(&mut self.#field, #place);)
    });
    Some(quote! {
        impl Traced for #this {
            #[inline]
            fn record(&mut self) {
                #(#pushes)*
            }
        }
    })
}

/// The name of the field and the method of a trace.
pub(super) fn trace_ident(emitter: &Emitter<'_>, trace: &Trace) -> Ident {
    let point = NamedPoint::new(emitter.model, trace.point);
    emitter.ident(&format!("{}_trace", point.ident()), point.origin)
}
