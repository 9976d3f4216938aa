//! Stages of a long step: the Rust compiler nests a scope for every `let` of a function.

use super::flow::{Flow, is_computed};
use super::scope::{Scope, Variable};
use crate::emit::tokens::{integer, position, scalar};
use crate::program::{Program, Value};
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::quote;
use std::collections::BTreeSet;

/// The largest number of `let`s in a generated function. From about three thousand on, the Rust compiler's stack overflows where
/// there is debug information.
pub(super) const MOST_LETS: usize = 512;

/// The largest number of `let`s in a stage, unless one act has more.
const STAGE: usize = 256;

/// The statements of a step for one block.
pub(super) struct Act {
    /// The statements, which bind all that the block gives.
    pub(super) statements: TokenStream,
    /// The number of their `let`s.
    pub(super) lets: usize,
    pub(super) flow: Flow,
    /// Whether it may end the step by an error.
    pub(super) fails: bool,
    /// Whether it computes sines by the step's parameter `S`.
    pub(super) takes_sines: bool,
}

/// The statements of a step.
pub(super) struct Body {
    pub(super) statements: TokenStream,
    /// The functions of its stages, if it has any.
    pub(super) functions: TokenStream,
}

/// The statements of a step, in stages if there would be too many `let`s with those `before` them.
pub(super) fn body(
    acts: Vec<Act>,
    before: usize,
    scope: &mut Scope<'_>,
    functions: &mut BTreeSet<String>,
) -> Body {
    let lets: usize = acts.iter().map(|act| act.lets).sum();
    if before + lets <= MOST_LETS {
        return Body {
            statements: acts.into_iter().map(|act| act.statements).collect(),
            functions: TokenStream::new(),
        };
    }
    let mut needed = roots(scope.program);
    let (mut stages, mut calls) = (Vec::new(), Vec::new());
    let groups = groups(acts);
    let count = groups.len();
    // From the last to the first: a stage gives what those after it take.
    for (index, acts) in groups.into_iter().enumerate().rev() {
        let number = index + 1;
        let name = scope.fresh_function(functions, &format!("stage_{number}"));
        let doc = format!(" Stage {number} of {count} of a step.");
        let stage = Stage::new(acts, &needed);
        needed.retain(|value| !stage.computes.contains(value));
        needed.extend(&stage.takes);
        stages.push(stage.function(&name, &doc, scope));
        calls.push(stage.call(&name, scope));
    }
    Body {
        statements: calls.into_iter().rev().collect(),
        functions: stages.into_iter().rev().collect(),
    }
}

/// The number of `let`s in some statements.
pub(super) fn count_lets(statements: &TokenStream) -> usize {
    let count = |tree: TokenTree| match tree {
        TokenTree::Ident(word) => usize::from(word == "let"),
        TokenTree::Group(group) => count_lets(&group.stream()),
        _ => 0,
    };
    statements.clone().into_iter().map(count).sum()
}

/// Consecutive acts, a stage each.
fn groups(acts: Vec<Act>) -> Vec<Vec<Act>> {
    let mut groups: Vec<Vec<Act>> = Vec::new();
    let mut room = 0;
    for act in acts {
        let lets = act.lets;
        match groups.last_mut() {
            Some(group) if lets <= room => {
                room -= lets;
                group.push(act);
            }
            _ => {
                room = STAGE.saturating_sub(lets);
                groups.push(vec![act]);
            }
        }
    }
    groups
}

/// The computed values among the results of a step.
fn roots(program: &Program) -> BTreeSet<Value> {
    let margins = program.margins().map(|(_, closed)| closed.margin);
    let margins = margins.filter(|_| program.is_closed());
    let all = program.roots().chain(margins);
    all.filter(|&value| is_computed(program.node(value).op)).collect()
}

/// Consecutive acts in a function of their own.
struct Stage {
    acts: Vec<Act>,
    /// All values that its acts give.
    computes: BTreeSet<Value>,
    takes: BTreeSet<Value>,
    /// Those of its values that later stages or the result need.
    gives: Vec<Value>,
    fails: bool,
    takes_sines: bool,
    reads_last: bool,
}

impl Stage {
    fn new(acts: Vec<Act>, needed: &BTreeSet<Value>) -> Self {
        let values = |part: fn(&Flow) -> &BTreeSet<Value>| {
            acts.iter().flat_map(move |act| part(&act.flow)).copied()
        };
        let computes: BTreeSet<Value> = values(|flow| &flow.gives).collect();
        let takes = values(|flow| &flow.takes);
        let takes = takes.filter(|value| !computes.contains(value)).collect();
        Self {
            takes,
            gives: computes.intersection(needed).copied().collect(),
            computes,
            fails: acts.iter().any(|act| act.fails),
            takes_sines: acts.iter().any(|act| act.takes_sines),
            reads_last: acts.iter().any(|act| act.flow.reads_last),
            acts,
        }
    }

    fn function(&self, name: &Ident, doc: &str, scope: &mut Scope<'_>) -> TokenStream {
        let (position, scalar) = (position(scope.program), scalar(scope.program.precision));
        let (takes, gives) = (scope.variables(&self.takes), scope.variables(&self.gives));
        let last = self.reads_last.then(|| quote!(last: &#position,));
        let sines = self.takes_sines.then(|| quote!(<S: Sines<#scalar>>));
        let many = (takes.len() > 6).then(|| {
            quote!(#[allow(clippy::too_many_arguments, reason = "a stage takes what earlier ones have found")])
        });
        let statements = self.acts.iter().map(|act| &act.statements);
        let (mut result, mut output) = (pattern(&gives), output(&gives, &scalar));
        let takes = takes.iter().map(|taken| {
            let (name, kind) = (&taken.name, kind(taken, &scalar));
            quote!(#name: #kind)
        });
        if self.fails {
            result = quote!(Ok(#result));
            output = quote!(Result<#output, Stop>);
        }
        quote! {
            #[doc = #doc]
            #many
            #[inline]
            fn #name #sines(#last #(#takes),*) -> #output {
                #(#statements)*
                #result
            }
        }
    }

    fn call(&self, name: &Ident, scope: &mut Scope<'_>) -> TokenStream {
        let (takes, gives) = (scope.variables(&self.takes), scope.variables(&self.gives));
        let (takes, gives) = (takes.iter().map(|taken| &taken.name), pattern(&gives));
        let last = self.reads_last.then(|| quote!(last,));
        let sines = self.takes_sines.then(|| quote!(::<S>));
        let fails = self.fails.then(|| quote!(?));
        quote!(let #gives = #name #sines(#last #(#takes),*)#fails;)
    }
}

/// The type of a variable.
fn kind(variable: &Variable, scalar: &TokenStream) -> TokenStream {
    match variable.rows {
        None => scalar.clone(),
        Some(rows) => {
            let rows = integer(rows);
            quote!([#scalar; #rows])
        }
    }
}

/// The results of a stage, as an expression and as a pattern: an array, unless there are arrays among them.
fn pattern(gives: &[Variable]) -> TokenStream {
    let names = gives.iter().map(|given| &given.name);
    if gives.iter().all(|given| given.rows.is_none()) {
        quote!([#(#names),*])
    } else {
        quote!((#(#names,)*))
    }
}

/// The type of the results of a stage.
fn output(gives: &[Variable], scalar: &TokenStream) -> TokenStream {
    if gives.iter().all(|given| given.rows.is_none()) {
        let length = integer(gives.len());
        quote!([#scalar; #length])
    } else {
        let kinds = gives.iter().map(|given| kind(given, scalar));
        quote!((#(#kinds,)*))
    }
}
