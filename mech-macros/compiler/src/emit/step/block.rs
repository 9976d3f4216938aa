//! One block as Rust.

use super::binding::{binding, system};
use super::flow::{Flow, is_given};
use super::iteration::iteration;
use super::scope::Scope;
use super::uses;
use crate::bug::bug;
use crate::emit::tokens::{integer, position, scalar};
use crate::program::{BlockId, BlockKind, Op, Program, Value};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// A block as statements for any function in which its inputs are bound.
pub(super) fn statements(block: BlockId, flow: &Flow, scope: &mut Scope<'_>) -> TokenStream {
    let program = scope.program;
    let mut tokens = last_poses(flow, scope);
    let mut newton = program.newton(block);
    for value in program.live_values() {
        let node = program.node(value);
        if node.block != block || node.iterated {
            continue;
        }
        if let Op::Solved(..) = node.op
            && let Some(newton) = newton.take()
        {
            tokens.extend(iteration(block, newton, scope));
        }
        if scope.is_bound(value) || is_given(node.op) {
            continue;
        }
        if let Op::Linear(number, _) = node.op {
            tokens.extend(linear(number, scope));
        } else if scope.deserves_name(value) || flow.gives.contains(&value) {
            tokens.extend(binding(value, scope));
        }
    }
    tokens
}

/// Some of the values of a straight block as statements for any function in which its inputs are bound.
pub(super) fn values_in_place(values: &[Value], flow: &Flow, scope: &mut Scope<'_>) -> TokenStream {
    let mut tokens = last_poses(flow, scope);
    for &value in values {
        if !scope.is_bound(value) && (scope.deserves_name(value) || flow.gives.contains(&value)) {
            tokens.extend(binding(value, scope));
        }
    }
    tokens
}

/// The `let`s of the last poses that are read.
fn last_poses(flow: &Flow, scope: &mut Scope<'_>) -> TokenStream {
    let mut tokens = TokenStream::new();
    for &link in &flow.links {
        let (name, index) = (scope.last_pose(link), integer(link));
        tokens.extend(quote!(let #name = last.poses[#index];));
    }
    tokens
}

/// The `let` of the unknowns and the determinant of a linear system of the motion.
fn linear(number: usize, scope: &mut Scope<'_>) -> TokenStream {
    let Some(found) = scope.program.systems().get(number) else {
        bug!("there is no linear system {number}");
    };
    let unknown = |index| Op::Linear(number, index);
    system(&found.columns, &found.right, unknown, scope)
}

/// A block as a function of its own, which gives these of its values.
pub(super) fn function(
    program: &Program,
    id: BlockId,
    name: &Ident,
    flow: &Flow,
    gives: &[Value],
    inline: &TokenStream,
) -> TokenStream {
    let block = &program.ssa.blocks[id.index()];
    let mut scope = Scope::new(program, uses(program, id), quote!(sin_cos));
    let takes = scope.bind_all(&flow.takes);
    let statements = statements(id, flow, &mut scope);
    let gives = scope.expressions(gives);
    let (scalar, position) = (scalar(program.precision), position(program));
    let last = flow.reads_last.then(|| quote!(last: &#position,));
    let doc = format!(" {}", block.title);
    let types = gives.iter().map(|_| &scalar);
    let many = (flow.takes.len() > 6).then(|| {
        quote!(#[allow(clippy::too_many_arguments, reason = "a loop has as many ends as it has")])
    });
    let (mut result, mut output) = (quote!((#(#gives),*)), quote!((#(#types),*)));
    if matches!(block.kind, BlockKind::Newton(_)) {
        result = quote!(Ok(#result));
        output = quote!(Result<#output, Stop>);
    }
    quote! {
        #[doc = #doc]
        #many
        #[#inline]
        fn #name(#last #(#takes: #scalar),*) -> #output {
            #statements
            #result
        }
    }
}
