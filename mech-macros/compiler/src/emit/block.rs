//! One block as Rust.

use super::flow::{Flow, is_given};
use super::iteration::iteration;
use super::scope::{Scope, uses};
use crate::program::{Block, BlockId, BlockKind, Op, Program, Value};
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
        let name = scope.last_pose(link);
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
        if let (Op::Linear(number, _), false) = (node.op, scope.is_bound(value)) {
            tokens.extend(linear(program, number, scope));
            continue;
        }
        if scope.is_bound(value)
            || is_given(node.op)
            || !(scope.deserves_name(value) || flow.gives.contains(&value))
        {
            continue;
        }
        tokens.extend(binding(program, value, scope));
    }
    tokens
}

/// The unknowns and the determinant of a linear system.
fn linear(program: &Program, number: usize, scope: &mut Scope<'_>) -> TokenStream {
    let systems = program.motion.iter().flat_map(|motion| &motion.systems);
    let Some(found) = systems.into_iter().nth(number) else {
        return TokenStream::new();
    };
    let unknown = |index| Op::Linear(number, index);
    system(program, (&found.columns, &found.right), unknown, scope)
}

/// The `let` of the unknowns and the determinant of a system: columns times unknowns and the right side add to zero.
pub(super) fn system(
    program: &Program,
    (columns, right): (&[Vec<Value>], &[Value]),
    unknown: impl Fn(usize) -> Op,
    scope: &mut Scope<'_>,
) -> TokenStream {
    let rows: Vec<TokenStream> = (0..right.len())
        .map(|row| {
            let parts = columns.iter().map(|column| scope.expression(column[row]));
            quote!([#(#parts),*])
        })
        .collect();
    let right: Vec<TokenStream> = right.iter().map(|&right| scope.negated(right)).collect();
    let bound: Vec<Ident> = (0..=columns.len())
        .map(|index| {
            let wanted = unknown(index);
            let mut live = program.live_values();
            match live.find(|&value| program.node(value).op == wanted) {
                Some(value) => scope.bind(value),
                None => scope.fresh("_unused"),
            }
        })
        .collect();
    let (unknowns, det) = bound.split_at(columns.len());
    quote!(let ([#(#unknowns),*], #(#det)*) = solve([#(#rows),*], [#(#right),*]);)
}

/// The `let` of a value; the sine and cosine of one angle are made together.
pub(super) fn binding(program: &Program, value: Value, scope: &mut Scope<'_>) -> TokenStream {
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
        let (angle, sines) = (scope.expression(angle), scope.sines().clone());
        let (sin, cos) = (scope.bind(sin), scope.bind(cos));
        return quote!(let (#sin, #cos) = #sines(#angle););
    }
    let made = scope.definition(value);
    let name = scope.bind(value);
    quote!(let #name = #made;)
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
            quote!(Result<(#(#types),*), Stop>),
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
    scalar_of(program.precision)
}

/// The scalar type of a precision.
pub(super) fn scalar_of(precision: crate::model::Precision) -> TokenStream {
    match precision {
        crate::model::Precision::F32 => quote!(f32),
        crate::model::Precision::F64 => quote!(f64),
    }
}
