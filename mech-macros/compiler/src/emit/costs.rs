//! The numbers of operations, as constants.

use super::Parts;
use super::emitter::Emitter;
use super::tokens::integer;
use crate::cost::{self, Cost};
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// `COST` and `LOOP_COSTS`: the cost of a position, and of each loop.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let visibility = emitter.visibility;
    let total = literal(cost::of_program(emitter.program));
    let of_loops = cost::of_loops(emitter.program);
    let count = integer(of_loops.len());
    let of_loops = of_loops.into_iter().map(literal);
    Parts {
        known: quote! {
            pub(super) const COST: Cost = #total;
            pub(super) const LOOP_COSTS: [Cost; #count] = [#(#of_loops),*];
        },
        methods: quote! {
            /// How many operations it takes to find a position.
            #visibility const COST: Cost = known::COST;

            /// How many of them each loop takes, in the order in which they are solved.
            #visibility const LOOP_COSTS: [Cost; #count] = known::LOOP_COSTS;
        },
        ..Parts::default()
    }
}

/// The constant `name`: the cost of what a derived program computes beyond a position.
pub(super) fn extra_cost(
    emitter: &Emitter<'_>,
    derived: &Program,
    name: &str,
    what: &str,
) -> TokenStream {
    let (visibility, name) = (emitter.visibility, format_ident!("{name}"));
    let cost = literal(cost::of_rates(emitter.program, derived));
    let doc = format!(" How many operations more it takes to find {what} with a position.");
    quote! {
        #[doc = #doc]
        #visibility const #name: Cost = #cost;
    }
}

/// A cost as an expression.
pub(super) fn literal(cost: Cost) -> TokenStream {
    let [additions, multiplications, divisions, square_roots, pairs, arctangents, selections] =
        cost.counts().map(Literal::u32_unsuffixed);
    quote! {
        Cost {
            additions: #additions,
            multiplications: #multiplications,
            divisions: #divisions,
            square_roots: #square_roots,
            sine_cosine_pairs: #pairs,
            arctangents: #arctangents,
            selections: #selections,
        }
    }
}
