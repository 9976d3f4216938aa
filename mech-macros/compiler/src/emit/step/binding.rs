//! The `let`s of values and of solved systems.

use super::scope::Scope;
use crate::program::{Op, Value};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// The `let` of a value; sine and cosine of one angle share it.
pub(super) fn binding(value: Value, scope: &mut Scope<'_>) -> TokenStream {
    let pair = match scope.program.node(value).op {
        Op::Sin(angle) => scope.value_of(Op::Cos(angle)).map(|cos| (angle, value, cos)),
        Op::Cos(angle) => scope.value_of(Op::Sin(angle)).map(|sin| (angle, sin, value)),
        _ => None,
    };
    if let Some((angle, sin, cos)) = pair {
        let pair = scope.sin_cos(angle);
        let (sin, cos) = (scope.bind(sin), scope.bind(cos));
        return quote!(let (#sin, #cos) = #pair;);
    }
    let definition = scope.definition(value);
    let name = scope.bind(value);
    quote!(let #name = #definition;)
}

/// The `let` of the unknowns and the determinant of a linear system. Columns times unknowns plus the right side are zero; `unknown`
/// is the operation that reads an unknown, and after the last of them the determinant.
pub(super) fn system(
    columns: &[Vec<Value>],
    right: &[Value],
    unknown: impl Fn(usize) -> Op,
    scope: &mut Scope<'_>,
) -> TokenStream {
    let rows = (0..right.len()).map(|row| {
        let row = scope.expressions(columns.iter().map(|column| &column[row]));
        quote!([#(#row),*])
    });
    let rows: Vec<TokenStream> = rows.collect();
    let right: Vec<TokenStream> = right.iter().map(|&right| scope.negation(right)).collect();
    let names = (0..=columns.len()).map(|index| match scope.value_of(unknown(index)) {
        Some(value) => scope.bind(value),
        None => scope.fresh("_unused"),
    });
    let names: Vec<Ident> = names.collect();
    let (unknowns, det) = names.split_at(columns.len());
    quote!(let ([#(#unknowns),*], #(#det)*) = solve([#(#rows),*], [#(#right),*]);)
}
