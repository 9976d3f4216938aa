//! What a position costs, as constants.

use crate::cost::{self, Cost};
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// The cost of everything, and of each loop; after them these as associated constants.
pub(super) fn costs(program: &Program, visibility: &syn::Visibility) -> (TokenStream, TokenStream) {
    let all = literal(cost::of_program(program));
    let of_loops = cost::of_loops(program);
    let count = Literal::usize_unsuffixed(of_loops.len());
    let of_loops = of_loops.into_iter().map(literal);
    let constants = quote! {
        pub(super) const COST: Cost = #all;
        pub(super) const LOOP_COSTS: [Cost; #count] = [#(#of_loops),*];
    };
    let associated = quote! {
        /// How many operations it takes to find a position.
        #visibility const COST: Cost = known::COST;

        /// How many of them each loop takes, in the order in which they are solved.
        #visibility const LOOP_COSTS: [Cost; #count] = known::LOOP_COSTS;
    };
    (constants, associated)
}

/// How many operations more a program takes that goes on from positions, as an associated constant.
pub(super) fn more(
    (program, derived): (&Program, &Program),
    name: &str,
    what: &str,
    visibility: &syn::Visibility,
) -> TokenStream {
    let name = format_ident!("{}", name);
    let cost = literal(cost::of_rates(program, derived));
    let doc = format!(" How many operations more it takes to find {what} with a position.");
    quote! {
        #[doc = #doc]
        #visibility const #name: Cost = #cost;
    }
}

pub(super) fn literal(cost: Cost) -> TokenStream {
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
        Cost {
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
