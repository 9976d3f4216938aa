//! The struct and its implementations.

use super::Parts;
use super::emitter::Emitter;
use super::known::known_module;
use super::step::step;
use super::tokens::integer;
use super::views::{Site, Views, views};
use super::{
    accessors, costs, drawing, forces, inverse, inverse_rates, joints, many, moves, overlay,
    params, rates, sensitivity, timing, traces,
};
use crate::compiled::Compiled;
use crate::syntax::{Header, Parsed};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The generated code of a coherent mechanism.
pub(crate) fn items(
    krate: &TokenStream,
    header: &Header,
    parsed: &Parsed,
    compiled: &Compiled,
) -> TokenStream {
    let emitter = &Emitter::new(krate, header, parsed, compiled);
    let Parts { fields, start, known: tables, methods, trait_items, modules } = parts(emitter);
    let this = alias(&header.name);
    let site = Site { krate, visibility: &header.visibility, this: &this };
    let Views { methods, items: views } = views(&site, &parsed.model, methods);
    let costs = costs::emit(emitter);
    let (cost_tables, cost_methods) = (costs.known, costs.methods);
    let known = known_module(emitter, &quote!(#cost_tables #tables));
    let (attributes, visibility, name) = (&header.attributes, &header.visibility, &header.name);
    let (implementation, tracing) =
        (implementation(emitter, &this, &trait_items), traces::implementation(emitter, &this));
    let step = step(krate, emitter.program);
    let program = emitter.program;
    let (scalar, doc) = (emitter.scalar_path(), format!("\n```text\n{}```", compiled.report));
    let sizes = [program.inputs(), program.poses.len(), program.state.len()].map(integer);
    quote! {
        #(#attributes)*
        #[doc = #doc]
        #[derive(
            #krate::generated::Clone, #krate::generated::Copy, #krate::generated::Debug, #krate::generated::PartialEq,
        )]
        #visibility struct #name {
            position: #krate::generated::Position<#scalar, #(#sizes),*>,
            #fields
        }

        const _: () = {
            // Under this name, because what is imported below may be called as the struct is.
            type #this = #name;

            #[allow(
                clippy::approx_constant,
                clippy::excessive_precision,
                clippy::inline_always,
                clippy::neg_multiply,
                clippy::suboptimal_flops,
                clippy::unreadable_literal,
                reason = "numbers were computed, and fused operations would not give the same bits on every machine"
            )]
            const _: () = {
            #[allow(
                unused_imports,
                clippy::wildcard_imports,
                reason = "which of them a mechanism needs depends on what it is made of",
            )]
            use #krate::generated::{self, *};
            // A parameter may stand before these functions. Where it met a constant, a static, a unit struct or a variant of its name
            // in the user's code, it would mean that.
            #[allow(unused_imports, clippy::wildcard_imports, reason = "parameters stand before these functions, where constants would stand before parameters")]
            use #krate::generated::parameters::*;

            #known

            #[allow(dead_code, reason = "nobody has to ask for every link, point and joint")]
            impl #this {
                /// Mobility, trunk and arms, and the loops in the order in which they are solved.
                #visibility const REPORT: &'static str = known::REPORT;

                #cost_methods

                /// The mechanism as it was assembled at compile time.
                #[must_use]
                #visibility const fn new() -> Self {
                    Self { position: known::START, #start }
                }

                #methods
            }

            impl Default for #this {
                fn default() -> Self {
                    Self::new()
                }
            }

            #implementation

            #tracing

            #views

            #step

            #modules
            };
        };
    }
}

/// The parts that all files add, in the order in which they stand in the generated code.
fn parts(emitter: &Emitter<'_>) -> Parts {
    let all = [
        moves::emit,
        moves::phases,
        moves::ranges,
        many::emit,
        rates::emit,
        forces::emit,
        inverse::emit,
        inverse_rates::emit,
        timing::emit,
        traces::emit,
        overlay::emit,
        params::emit,
        sensitivity::emit,
        joints::emit,
        drawing::emit,
        accessors::emit,
    ];
    all.into_iter().map(|emit| emit(emitter)).collect()
}

/// The name of the struct in the generated code.
fn alias(name: &Ident) -> Ident {
    if name == "ThisMechanism" {
        format_ident!("TheMechanism")
    } else {
        format_ident!("ThisMechanism")
    }
}

/// The implementation of `Mechanism`, by the inherent methods.
fn implementation(emitter: &Emitter<'_>, this: &Ident, trait_items: &TokenStream) -> TokenStream {
    let Emitter { scalar, values, blocked, program, .. } = emitter;
    let (motor_names, link_names) = (&program.motors, &program.links);
    let name = emitter.header.name.to_string();
    quote! {
            impl Mechanism for #this {
                type Scalar = #scalar;
                type Motors = #values;
                const NAME: &'static str = #name;
                const REPORT: &'static str = known::REPORT;
                const COST: Cost = known::COST;
                const LOOP_COSTS: &'static [Cost] = &known::LOOP_COSTS;
                const MOTORS: &'static [&'static str] = &[#(#motor_names),*];
                const LINKS: &'static [&'static str] = &[#(#link_names),*];
                const SHAPES: &'static [Shape<#scalar>] = known::SHAPES;
                const EXTENT: [[#scalar; 2]; 2] = known::EXTENT;

                fn new() -> Self {
                    Self::new()
                }

                fn motors(&self) -> #values {
                    Self::motors(self)
                }

                fn move_to(&mut self, motors: #values) -> Result<(), #blocked> {
                    Self::move_to(self, motors)
                }

                fn move_toward(&mut self, motors: #values) -> Result<Reached<#values>, #blocked> {
                    Self::move_toward(self, motors)
                }

                fn poses(&self) -> &[Pose<#scalar>] {
                    Self::poses(self)
                }

                #trait_items
            }
    }
}
