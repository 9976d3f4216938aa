//! One block as Rust.

use super::flow::Flow;
use super::scope::{Scope, last_pose, number, uses};
use crate::program::{Block, BlockId, BlockKind, Newton, Op, Program, Rounds, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// A block as statements that may stand in any function where what it takes is bound in `scope`.
pub(super) fn statements(
    program: &Program,
    block: BlockId,
    flow: &Flow,
    scope: &mut Scope<'_>,
) -> TokenStream {
    let mut tokens = TokenStream::new();
    for &link in &flow.links {
        let name = last_pose(program, link);
        let index = Literal::usize_unsuffixed(link);
        tokens.extend(quote!(let #name = last.poses[#index];));
    }
    let newton = program.newton(block);
    let mut solved = false;
    for value in program.live_values() {
        let node = program.node(value);
        if node.block != block || node.iterated {
            continue;
        }
        if let (Op::Solved(..), Some(newton), false) = (node.op, newton, solved) {
            tokens.extend(iteration(program, block, newton, scope));
            solved = true;
        }
        if scope.is_bound(value) || !(scope.deserves_name(value) || flow.gives.contains(&value)) {
            continue;
        }
        tokens.extend(binding(program, value, scope));
    }
    tokens
}

/// The `let` of a value; the sine and cosine of one angle are made together.
fn binding(program: &Program, value: Value, scope: &mut Scope<'_>) -> TokenStream {
    let twin = |wanted: Op| {
        program
            .live_values()
            .find(|&other| program.node(other).op == wanted)
    };
    let pair = match program.node(value).op {
        Op::Sin(angle) => twin(Op::Cos(angle)).map(|cos| (angle, value, cos)),
        Op::Cos(angle) => twin(Op::Sin(angle)).map(|sin| (angle, sin, value)),
        _ => None,
    };
    if let Some((angle, sin, cos)) = pair {
        let angle = scope.expression(angle);
        let (sin, cos) = (scope.bind(sin), scope.bind(cos));
        return quote!(let (#sin, #cos) = sin_cos(#angle););
    }
    let made = scope.definition(value);
    let name = scope.bind(value);
    quote!(let #name = #made;)
}

/// The iteration of a loop, and the test of its result.
fn iteration(
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
    let body: Vec<Value> = program
        .live_values()
        .filter(|&value| program.node(value).block == block && program.node(value).iterated)
        .filter(|&value| !scope.is_bound(value))
        .collect();
    // What the test of the result needs. Constants and what is known beforehand need not be carried out of the iteration.
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
    let rates = newton
        .columns
        .iter()
        .flatten()
        .filter(|_| newton.dense)
        .copied();
    let measured = reached(program, &body, exits.iter().copied().chain(rates));
    let bind = |values: &[Value], scope: &mut Scope<'_>| -> TokenStream {
        let dense = |value: Value| matches!(program.node(value).op, Op::Dense(..));
        let named = values
            .iter()
            .filter(|&&value| {
                !dense(value) && (exits.contains(&value) || scope.deserves_name(value))
            })
            .copied();
        let named: Vec<Value> = named.collect();
        named
            .into_iter()
            .map(|value| binding(program, value, scope))
            .collect()
    };
    let (before, after): (Vec<Value>, Vec<Value>) =
        body.iter().partition(|value| measured.contains(value));
    let mut before = bind(&before, scope);
    before.extend(newton.dense.then(|| dense(program, block, newton, scope)));
    let after = bind(&after, scope);
    let next: Vec<TokenStream> = newton
        .scalars
        .iter()
        .map(|scalar| scope.expression(scalar.next))
        .collect();
    let gap: Vec<TokenStream> = newton
        .gap
        .iter()
        .map(|&value| scope.expression(value))
        .collect();
    let det = scope.expression(newton.det);
    let exits: Vec<TokenStream> = exits.iter().map(|&value| scope.expression(value)).collect();
    let epsilon = program.precision.epsilon();
    let limit = |part: f64| size(program, newton, part, scope);
    let enough = match newton.rounds {
        Rounds::Exactly(rounds) => {
            let rounds = Literal::u32_unsuffixed(rounds);
            quote!(rounds == #rounds)
        }
        Rounds::UntilClosed(most) => {
            let (most, tight) = (Literal::u32_unsuffixed(most), limit(newton.tight(epsilon)));
            let greatest = greatest(&gap);
            quote!(rounds == #most || #greatest <= #tight)
        }
    };
    let accept = limit(newton.accept(epsilon));
    let floor = number(program.precision, newton.floor(epsilon));
    let place = &newton.place;
    let signed = if newton.limits.positive {
        quote!(#det)
    } else {
        quote!(-#det)
    };
    quote! {
        #(let mut #variables = #firsts;)*
        let mut rounds = 0_u32;
        let (#(#exits),*) = loop {
            #before
            if #enough {
                break (#(#exits),*);
            }
            #after
            (#(#variables),*) = (#(#next),*);
            rounds += 1;
        };
        closed([#(#gap),*], #accept, #signed, #floor, #place)?;
    }
}

/// The greatest of the absolute values.
fn greatest(gap: &[TokenStream]) -> TokenStream {
    let mut parts = gap.iter().map(|part| quote!(#part.abs()));
    let first = parts.next().unwrap_or_default();
    parts.fold(first, |greatest, part| quote!(#greatest.max(#part)))
}

/// The steps and the determinant of coupled loops, from their dense system.
fn dense(program: &Program, block: BlockId, newton: &Newton, scope: &mut Scope<'_>) -> TokenStream {
    let rows = (0..newton.gap.len()).map(|row| {
        let rates = newton
            .columns
            .iter()
            .map(|column| scope.expression(column[row]));
        quote!([#(#rates),*])
    });
    let rows: Vec<TokenStream> = rows.collect();
    let gap: Vec<TokenStream> = newton
        .gap
        .iter()
        .map(|&gap| scope.expression(gap))
        .collect();
    let value = |index| {
        program
            .live_values()
            .find(|&value| program.node(value).op == Op::Dense(block, index))
    };
    let bound: Vec<Ident> = (0..=newton.columns.len())
        .map(|index| match value(index) {
            Some(value) => scope.bind(value),
            None => scope.fresh("_unused"),
        })
        .collect();
    let (steps, det) = bound.split_at(newton.columns.len());
    quote!(let ([#(#steps),*], #(#det)*) = solve([#(#rows),*], [#(-#gap),*]);)
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

/// A block as a function of its own, and the call of it.
pub(super) fn function(
    program: &Program,
    id: BlockId,
    name: &Ident,
    flow: &Flow,
    position: &TokenStream,
) -> TokenStream {
    let block: &Block = &program.blocks[id.index()];
    let mut scope = Scope::new(program, uses(program, id));
    let takes: Vec<Ident> = flow.takes.iter().map(|&value| scope.bind(value)).collect();
    let statements = statements(program, id, flow, &mut scope);
    let gives: Vec<TokenStream> = flow
        .gives
        .iter()
        .map(|&value| scope.expression(value))
        .collect();
    let scalar = scalar(program);
    let last = flow.reads_last.then(|| quote!(last: &#position,));
    let doc = format!(" {}", block.title);
    let types = gives.iter().map(|_| &scalar);
    let many = (flow.takes.len() > 6).then(|| {
        quote!(#[allow(clippy::too_many_arguments, reason = "a loop has as many ends as it has")])
    });
    let fails = matches!(block.kind, BlockKind::Newton(_));
    let (result, output) = if fails {
        (
            quote!(Ok((#(#gives),*))),
            quote!(Result<(#(#types),*), Blocked>),
        )
    } else {
        (quote!((#(#gives),*)), quote!((#(#types),*)))
    };
    quote! {
        #[doc = #doc]
        #many
        #[inline]
        fn #name(#last #(#takes: #scalar),*) -> #output {
            #statements
            #result
        }
    }
}

/// The scalar type that is emitted.
pub(super) fn scalar(program: &Program) -> TokenStream {
    match program.precision {
        crate::model::Precision::F32 => quote!(f32),
        crate::model::Precision::F64 => quote!(f64),
    }
}
