//! The iteration of a loop as Rust.

use super::binding::{binding, system};
use super::scope::Scope;
use crate::bug::bug;
use crate::emit::tokens::number;
use crate::program::{BlockId, Newton, Op, Program, Rounds, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// The iteration of a loop, and the test of its result.
pub(super) fn iteration(block: BlockId, newton: &Newton, scope: &mut Scope<'_>) -> TokenStream {
    let program = scope.program;
    let firsts = scope.expressions(newton.scalars.iter().map(|scalar| &scalar.first));
    let variables = variables(block, newton, scope);
    let body = program.live_values().filter(|&value| {
        let node = program.node(value);
        node.block == block && node.iterated && !scope.is_bound(value)
    });
    let body: Vec<Value> = body.collect();
    let exits = exits(newton, &body);
    let round = Round::new(program, newton, &body, &exits);
    let before = round.before(block, newton, scope);
    let after = round.bindings(&round.after, scope);
    let next = scope.expressions(newton.scalars.iter().map(|scalar| &scalar.next));
    let exits = scope.expressions(&exits);
    let exits = quote!((#(#exits),*));
    let first_step = newton.contracting_step().map(|_| quote!(let mut before = before_first();));
    let contracts = newton.contracting_step().map(|step| {
        let step = scope.expression(step);
        quote!(!contracts(&mut before, #step))
    });
    let is_last = is_last(newton, scope);
    let test = test(newton, scope);
    let step = quote!((#(#variables),*) = (#(#next),*););
    let rest = if newton.steps_on() {
        let stop = contracts.map(|stop| quote!(if !is_last && #stop { break #exits; }));
        quote! {
            let is_last = #is_last;
            if is_last && rounds == 0 {
                break #exits;
            }
            #after
            #stop
            #step
            if is_last {
                break #exits;
            }
        }
    } else {
        let stop = contracts.map(|stop| quote!(if #stop { break #exits; }));
        quote! {
            if #is_last {
                break #exits;
            }
            #after
            #stop
            #step
        }
    };
    quote! {
        #(let mut #variables = #firsts;)*
        let mut rounds = 0_u32;
        #first_step
        let #exits = loop {
            #before
            #rest
            rounds += 1;
        };
        #test
    }
}

/// The variables that are iterated. After the last round they are the solution.
fn variables(block: BlockId, newton: &Newton, scope: &mut Scope<'_>) -> Vec<Ident> {
    let scalars = newton.scalars.iter();
    let variables: Vec<Ident> = scalars.map(|scalar| scope.fresh(&scalar.name)).collect();
    for (index, (scalar, variable)) in newton.scalars.iter().zip(&variables).enumerate() {
        scope.alias(scalar.now, variable.clone());
        if let Some(solution) = scope.value_of(Op::Solved(block, index)) {
            scope.alias(solution, variable.clone());
        }
    }
    variables
}

/// The values of a round that the test of the result reads. Those known before the iteration need not leave it.
fn exits(newton: &Newton, body: &[Value]) -> Vec<Value> {
    let gap = newton.gap.iter().copied();
    let mut exits: Vec<Value> = Vec::new();
    for value in gap.chain([newton.det]).chain(newton.extent) {
        if body.contains(&value) && !exits.contains(&value) {
            exits.push(value);
        }
    }
    exits
}

/// The values of one round.
struct Round<'r> {
    program: &'r Program,
    exits: &'r [Value],
    /// The values from which the gap and the columns are computed.
    columns: Vec<Value>,
    /// The determinant of a dense system, and what is computed from it.
    solved: Vec<Value>,
    /// The values that are needed only if another round follows.
    after: Vec<Value>,
}

impl<'r> Round<'r> {
    fn new(program: &'r Program, newton: &Newton, body: &[Value], exits: &'r [Value]) -> Self {
        let rates = newton.columns.iter().flatten();
        let rates = rates.filter(|_| newton.dense);
        let needed = operands(program, body, exits.iter().chain(rates).copied().collect());
        let (before, after): (Vec<Value>, Vec<Value>) =
            body.iter().partition(|value| needed.contains(value));
        let (solved, columns) = before.iter().partition(|&&value| {
            let mut operands = operands(program, body, vec![value]).into_iter();
            operands.any(|value| is_dense(program, value))
        });
        Self { program, exits, columns, solved, after }
    }

    /// The statements before the test whether a round is the last.
    fn before(&self, block: BlockId, newton: &Newton, scope: &mut Scope<'_>) -> TokenStream {
        let columns = self.bindings(&self.columns, scope);
        let dense = newton.dense.then(|| {
            let unknown = |index| Op::Dense(block, index);
            system(&newton.columns, &newton.gap, unknown, scope)
        });
        let solved = self.bindings(&self.solved, scope);
        quote!(#columns #dense #solved)
    }

    /// The `let`s of those values that leave the iteration or deserve a name.
    fn bindings(&self, values: &[Value], scope: &mut Scope<'_>) -> TokenStream {
        let is_bound = |value: Value| {
            !is_dense(self.program, value)
                && (self.exits.contains(&value) || scope.deserves_name(value))
        };
        let values = values.iter().copied();
        let bound: Vec<Value> = values.filter(|&value| is_bound(value)).collect();
        let bindings = bound.into_iter().map(|value| binding(value, scope));
        bindings.collect()
    }
}

fn is_dense(program: &Program, value: Value) -> bool {
    matches!(program.node(value).op, Op::Dense(..))
}

/// The test whether a round is the last.
fn is_last(newton: &Newton, scope: &Scope<'_>) -> TokenStream {
    match newton.rounds {
        Rounds::Exactly(rounds) => {
            let rounds = Literal::u32_unsuffixed(rounds);
            quote!(rounds == #rounds)
        }
        Rounds::UntilClosed(most) => {
            let (most, gap) = (Literal::u32_unsuffixed(most), largest(newton, scope));
            let epsilon = scope.program.precision.epsilon();
            let tight = share_of_size(newton, newton.tight(epsilon), scope);
            quote!(rounds == #most || #gap <= #tight)
        }
    }
}

/// The test of the result.
fn test(newton: &Newton, scope: &Scope<'_>) -> TokenStream {
    let precision = scope.program.precision;
    let epsilon = precision.epsilon();
    let gap = scope.expressions(&newton.gap);
    let accept = share_of_size(newton, newton.accept(epsilon), scope);
    let floor = number(precision, newton.floor(epsilon));
    let det = scope.expression(newton.det);
    let sign = (!newton.limits.positive).then(|| quote!(-));
    let place = &newton.place;
    quote!(closed([#(#gap),*], #accept, #sign #det, #floor, #place)?;)
}

/// The largest of the absolute values of the gap.
fn largest(newton: &Newton, scope: &Scope<'_>) -> TokenStream {
    let gap = newton.gap.iter().map(|&part| {
        let part = scope.expression(part);
        quote!(#part.abs())
    });
    let largest = gap.reduce(|largest, part| quote!(#largest.max(#part)));
    largest.unwrap_or_else(|| bug!("an iterated loop has no gap"))
}

/// A share of the present size of a loop, in scene units.
fn share_of_size(newton: &Newton, share: f64, scope: &Scope<'_>) -> TokenStream {
    let (precision, fixed) = (scope.program.precision, newton.limits.size);
    match newton.extent {
        None => number(precision, share * fixed),
        Some(extent) => {
            let [share, fixed] = [share, fixed].map(|value| number(precision, value));
            let extent = scope.expression(extent);
            quote!(#share * (#fixed + #extent))
        }
    }
}

/// The values among these that the roots are computed from, roots included.
fn operands(program: &Program, among: &[Value], roots: Vec<Value>) -> Vec<Value> {
    let mut operands = Vec::new();
    let mut waiting = roots;
    while let Some(value) = waiting.pop() {
        if among.contains(&value) && !operands.contains(&value) {
            operands.push(value);
            waiting.extend(program.node(value).op.operands());
        }
    }
    operands
}
