//! The iteration of a loop as Rust.

use super::block::{binding, system};
use super::scope::{Scope, number};
use crate::bug::bug;
use crate::program::{BlockId, Newton, Op, Program, Rounds, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// The iteration of a loop, and the test of its result.
pub(super) fn iteration(
    program: &Program,
    block: BlockId,
    newton: &Newton,
    scope: &mut Scope<'_>,
) -> TokenStream {
    let firsts: Vec<TokenStream> = newton
        .scalars
        .iter()
        .map(|scalar| scope.expression(scalar.first))
        .collect();
    let variables = variables(program, block, newton, scope);
    let body: Vec<Value> = program
        .live_values()
        .filter(|&value| program.node(value).block == block && program.node(value).iterated)
        .filter(|&value| !scope.is_bound(value))
        .collect();
    let exits = exits(newton, &body);
    let (before, after) = round(program, block, newton, (&body, &exits), scope);
    let next: Vec<TokenStream> = newton
        .scalars
        .iter()
        .map(|scalar| scope.expression(scalar.next))
        .collect();
    let exits: Vec<TokenStream> = exits.iter().map(|&value| scope.expression(value)).collect();
    let (start, contracts) = contraction(newton, &exits, scope);
    let enough = enough(program, newton, scope);
    let test = test(program, newton, scope);
    quote! {
        #(let mut #variables = #firsts;)*
        let mut rounds = 0_u32;
        #start
        let (#(#exits),*) = loop {
            #before
            if #enough {
                break (#(#exits),*);
            }
            #after
            #contracts
            (#(#variables),*) = (#(#next),*);
            rounds += 1;
        };
        #test
    }
}

/// The variables that are iterated. After the last round they are the solution.
fn variables(
    program: &Program,
    block: BlockId,
    newton: &Newton,
    scope: &mut Scope<'_>,
) -> Vec<Ident> {
    let variables: Vec<Ident> = newton
        .scalars
        .iter()
        .map(|scalar| scope.fresh(&scalar.name))
        .collect();
    for (index, (scalar, variable)) in newton.scalars.iter().zip(&variables).enumerate() {
        scope.alias(scalar.now, variable.clone());
        let solved = program
            .live_values()
            .find(|&value| program.node(value).op == Op::Solved(block, index));
        if let Some(solved) = solved {
            scope.alias(solved, variable.clone());
        }
    }
    variables
}

/// What the test of the result needs. Constants and what is known beforehand need not be carried out of the iteration.
fn exits(newton: &Newton, body: &[Value]) -> Vec<Value> {
    let test = newton
        .gap
        .iter()
        .copied()
        .chain([newton.det])
        .chain(newton.extent);
    let mut exits: Vec<Value> = Vec::new();
    for value in test {
        if body.contains(&value) && !exits.contains(&value) {
            exits.push(value);
        }
    }
    exits
}

/// The statements of a round: those before the test whether it is the last, and those after.
fn round(
    program: &Program,
    block: BlockId,
    newton: &Newton,
    (body, exits): (&[Value], &[Value]),
    scope: &mut Scope<'_>,
) -> (TokenStream, TokenStream) {
    let rates = newton
        .columns
        .iter()
        .flatten()
        .filter(|_| newton.dense)
        .copied();
    let measured = reached(program, body, exits.iter().copied().chain(rates));
    let bind = |values: &[Value], scope: &mut Scope<'_>| -> TokenStream {
        let dense = |value: Value| matches!(program.node(value).op, Op::Dense(..));
        let wanted =
            |value: Value| !dense(value) && (exits.contains(&value) || scope.deserves_name(value));
        let named: Vec<Value> = values
            .iter()
            .copied()
            .filter(|&value| wanted(value))
            .collect();
        named
            .into_iter()
            .map(|value| binding(program, value, scope))
            .collect()
    };
    let (before, after): (Vec<Value>, Vec<Value>) =
        body.iter().partition(|value| measured.contains(value));
    // The determinant of a dense system, and what is made from it, come after its columns.
    let is_dense = |value: &Value| matches!(program.node(*value).op, Op::Dense(..));
    let (solved, columns): (Vec<Value>, Vec<Value>) = before.iter().partition(|&&value| {
        reached(program, body, [value].into_iter())
            .iter()
            .any(is_dense)
    });
    let mut before = bind(&columns, scope);
    before.extend(newton.dense.then(|| dense(program, block, newton, scope)));
    before.extend(bind(&solved, scope));
    (before, bind(&after, scope))
}

/// Whether a round is the last.
fn enough(program: &Program, newton: &Newton, scope: &Scope<'_>) -> TokenStream {
    match newton.rounds {
        Rounds::Exactly(rounds) => {
            let rounds = Literal::u32_unsuffixed(rounds);
            quote!(rounds == #rounds)
        }
        Rounds::UntilClosed(most) => {
            let gap: Vec<TokenStream> = newton
                .gap
                .iter()
                .map(|&value| scope.expression(value))
                .collect();
            let (most, greatest) = (Literal::u32_unsuffixed(most), greatest(&gap));
            let tight = size(
                program,
                newton,
                newton.tight(program.precision.epsilon()),
                scope,
            );
            quote!(rounds == #most || #greatest <= #tight)
        }
    }
}

/// The test of the result.
fn test(program: &Program, newton: &Newton, scope: &Scope<'_>) -> TokenStream {
    let epsilon = program.precision.epsilon();
    let gap = newton.gap.iter().map(|&value| scope.expression(value));
    let accept = size(program, newton, newton.accept(epsilon), scope);
    let floor = number(program.precision, newton.floor(epsilon));
    let det = scope.expression(newton.det);
    let signed = if newton.limits.positive {
        quote!(#det)
    } else {
        quote!(-#det)
    };
    let place = &newton.place;
    quote!(closed([#(#gap),*], #accept, #signed, #floor, #place)?;)
}

/// The end of an iteration whose steps do not become smaller, and what the first is compared with.
fn contraction(
    newton: &Newton,
    exits: &[TokenStream],
    scope: &Scope<'_>,
) -> (TokenStream, TokenStream) {
    let Some(step) = newton.contracting() else {
        return (TokenStream::new(), TokenStream::new());
    };
    let step = scope.expression(step);
    (
        quote!(let mut before = before_first();),
        quote!(if !contracts(&mut before, #step) { break (#(#exits),*); }),
    )
}

/// The greatest of the absolute values.
fn greatest(gap: &[TokenStream]) -> TokenStream {
    let mut parts = gap.iter().map(|part| quote!(#part.abs()));
    let Some(first) = parts.next() else {
        bug!("an iterated loop has no gap");
    };
    parts.fold(first, |greatest, part| quote!(#greatest.max(#part)))
}

/// The steps and the determinant of coupled loops, from their dense system.
fn dense(program: &Program, block: BlockId, newton: &Newton, scope: &mut Scope<'_>) -> TokenStream {
    let unknown = |index| Op::Dense(block, index);
    system(program, (&newton.columns, &newton.gap), unknown, scope)
}

/// A part of the present size of a loop.
fn size(program: &Program, newton: &Newton, part: f64, scope: &Scope<'_>) -> TokenStream {
    let fixed = newton.limits.size;
    match newton.extent {
        None => number(program.precision, part * fixed),
        Some(extent) => {
            let (part, fixed) = (
                number(program.precision, part),
                number(program.precision, fixed),
            );
            let extent = scope.expression(extent);
            quote!(#part * (#fixed + #extent))
        }
    }
}

/// Which of these values the roots are made from.
fn reached(program: &Program, among: &[Value], roots: impl Iterator<Item = Value>) -> Vec<Value> {
    let mut reached = Vec::new();
    let mut waiting: Vec<Value> = roots.collect();
    while let Some(value) = waiting.pop() {
        if among.contains(&value) && !reached.contains(&value) {
            reached.push(value);
            waiting.extend(program.node(value).op.operands());
        }
    }
    reached
}
