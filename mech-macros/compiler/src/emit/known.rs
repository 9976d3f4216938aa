//! The module of what is known at compile time. It is apart from everything that takes parameters: where a constant is in scope, a
//! parameter of its name would be taken for a pattern.

use super::moves::limits;
use super::scope::number;
use super::shapes::shapes;
use super::step::position;
use crate::compiled::Compiled;
use crate::model::Model;
use crate::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

/// The module with the tables that every mechanism has, and with these.
pub(super) fn known(
    krate: &TokenStream,
    model: &Model,
    compiled: &Compiled,
    others: &TokenStream,
) -> TokenStream {
    let Compiled {
        plan,
        program,
        report,
        ..
    } = compiled;
    let (position, start) = (position(program), start(program));
    let (shapes, limits) = (shapes(model, plan, program), limits(model, program, plan));
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

            #others
        }
    }
}

/// The assembled position.
fn start(program: &Program) -> TokenStream {
    let n = |value: &f64| number(program.precision, *value);
    let motors = program.start.motors.iter().map(n);
    let state = program.start.state.iter().map(n);
    let poses = program.start.poses.iter().map(|pose| {
        let [cos, sin, x, y] = pose.each_ref().map(n);
        quote!(Pose { cos: #cos, sin: #sin, x: #x, y: #y })
    });
    quote!(Position { motors: Motors::new([#(#motors),*]), poses: [#(#poses),*], state: [#(#state),*] })
}
