//! What a position costs, as constants.

use crate::cost::{self, Cost};
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// The cost of everything, and of each loop; after them these as associated constants.
pub(super) fn costs(
    krate: &TokenStream,
    program: &Program,
    visibility: &syn::Visibility,
) -> (TokenStream, TokenStream) {
    let all = literal(krate, cost::of_program(program));
    let of_loops = cost::of_loops(program);
    let count = Literal::usize_unsuffixed(of_loops.len());
    let of_loops = of_loops.into_iter().map(|cost| literal(krate, cost));
    let constants = quote! {
        const COST: #krate::Cost = #all;
        const LOOP_COSTS: [#krate::Cost; #count] = [#(#of_loops),*];
    };
    let associated = quote! {
        /// How many operations it takes to find a position.
        #visibility const COST: #krate::Cost = COST;

        /// How many of them each loop takes, in the order in which they are solved.
        #visibility const LOOP_COSTS: [#krate::Cost; #count] = LOOP_COSTS;
    };
    (constants, associated)
}

/// How many operations more a program takes that goes on from positions, as an associated constant.
pub(super) fn more(
    krate: &TokenStream,
    (program, further): (&Program, &Program),
    name: &str,
    what: &str,
    visibility: &syn::Visibility,
) -> TokenStream {
    let name = format_ident!("{}", name);
    let cost = literal(krate, cost::of_rates(program, further));
    let doc = format!(" How many operations more it takes to find {what} with a position.");
    quote! {
        #[doc = #doc]
        #visibility const #name: #krate::Cost = #cost;
    }
}

pub(super) fn literal(krate: &TokenStream, cost: Cost) -> TokenStream {
    let [
        additions,
        multiplications,
        divisions,
        square_roots,
        sine_cosine_pairs,
        arctangents,
        selections,
    ] = [
        cost.additions,
        cost.multiplications,
        cost.divisions,
        cost.square_roots,
        cost.sine_cosine_pairs,
        cost.arctangents,
        cost.selections,
    ]
    .map(Literal::u32_unsuffixed);
    quote! {
        #krate::Cost {
            additions: #additions,
            multiplications: #multiplications,
            divisions: #divisions,
            square_roots: #square_roots,
            sine_cosine_pairs: #sine_cosine_pairs,
            arctangents: #arctangents,
            selections: #selections,
        }
    }
}
