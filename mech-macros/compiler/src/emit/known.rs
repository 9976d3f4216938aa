//! The module of what is known at compile time. It is apart from everything that takes parameters: where a constant is in scope, a
//! parameter of its name would be taken for a pattern.

use super::emitter::Emitter;
use super::limits::limits;
use super::shapes::shapes;
use super::tokens::position;
use proc_macro2::TokenStream;
use quote::quote;

/// The module `known`, with the tables that every mechanism has and with `tables`.
pub(super) fn known_module(emitter: &Emitter<'_>, tables: &TokenStream) -> TokenStream {
    let (krate, report) = (emitter.krate, &emitter.compiled.report);
    let (position, start) = (position(emitter.program), start(emitter));
    let (shapes, limits) = (shapes(emitter), limits(emitter));
    quote! {
        mod known {
            #[allow(
                unused_imports,
                clippy::wildcard_imports,
                reason = "which of them a mechanism needs depends on what it is made of",
            )]
            use #krate::generated::*;

            #shapes

            pub(super) const START: #position = #start;

            #limits

            pub(super) const REPORT: &str = #report;

            #tables
        }
    }
}

/// The position at the start.
pub(super) fn start(emitter: &Emitter<'_>) -> TokenStream {
    let start = &emitter.program.start;
    let n = |value: &f64| emitter.number(*value);
    let (motors, state) = (start.motors.iter().map(n), start.state.iter().map(n));
    let poses = start.poses.iter().map(|pose| {
        let [cos, sin, x, y] = pose.each_ref().map(n);
        quote!(Pose { cos: #cos, sin: #sin, x: #x, y: #y })
    });
    quote!(Position { motors: Motors::new([#(#motors),*]), poses: [#(#poses),*], state: [#(#state),*] })
}
