//! What a step does, in stages if it is long: the Rust compiler nests a scope for every `let` of a function.

use super::block::scalar;
use super::flow::{Flow, is_made};
use super::scope::{FunctionNames, Scope};
use super::step::position;
use crate::program::{Program, Value};
use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use quote::quote;
use std::collections::BTreeSet;

/// The `let`s of a generated function are at most so many: from about three thousand on the Rust compiler's stack overflows where
/// there is debug information.
pub(super) const MOST_LETS: usize = 512;

/// The `let`s of a stage.
const STAGE: usize = 256;

/// What a step does for one block.
pub(super) struct Act {
    /// How: it binds all that it gives.
    pub(super) statements: TokenStream,
    /// How many `let`s these have.
    pub(super) lets: usize,
    pub(super) flow: Flow,
    /// Whether it may end the step by an error.
    pub(super) fails: bool,
    /// Whether it takes sines from where the step is told to.
    pub(super) takes_sines: bool,
}

/// The statements of a step, and the functions of its stages if it has any. `before` are the `let`s that precede them.
pub(super) fn in_stages(
    program: &Program,
    acts: Vec<Act>,
    before: usize,
    scope: &mut Scope<'_>,
    names: &mut FunctionNames,
) -> (TokenStream, TokenStream) {
    let lets: usize = acts.iter().map(|act| act.lets).sum();
    if before + lets <= MOST_LETS {
        let body = acts.into_iter().map(|act| act.statements).collect();
        return (TokenStream::new(), body);
    }
    let mut needed = needed(program);
    let mut stages: Vec<TokenStream> = Vec::new();
    let mut calls: Vec<TokenStream> = Vec::new();
    let stages_of_acts = grouped(acts);
    let count = stages_of_acts.len();
    // From the last to the first: what one takes, those before it have to give.
    for (number, acts) in stages_of_acts.into_iter().enumerate().rev() {
        let name = scope.fresh_function(names, &format!("stage_{}", number + 1));
        let stage = Stage::new(acts, &needed);
        needed.retain(|value| !stage.makes.contains(value));
        needed.extend(stage.takes.iter().copied());
        stages.push(stage.function(program, &name, (number + 1, count), scope));
        calls.push(stage.call(&name, scope));
    }
    stages.reverse();
    calls.reverse();
    (stages.into_iter().collect(), calls.into_iter().collect())
}

/// How many `let`s there are in some statements.
pub(super) fn lets(statements: &TokenStream) -> usize {
    let count = |tree: TokenTree| match tree {
        TokenTree::Ident(word) => usize::from(word == "let"),
        TokenTree::Group(group) => lets(&group.stream()),
        _ => 0,
    };
    statements.clone().into_iter().map(count).sum()
}

/// Acts that follow each other, a stage at a time.
fn grouped(acts: Vec<Act>) -> Vec<Vec<Act>> {
    let mut stages: Vec<Vec<Act>> = Vec::new();
    let mut room = 0;
    for act in acts {
        let lets = act.lets;
        match stages.last_mut() {
            Some(stage) if lets <= room => {
                room -= lets;
                stage.push(act);
            }
            _ => {
                room = STAGE.saturating_sub(lets);
                stages.push(vec![act]);
            }
        }
    }
    stages
}

/// What the result of a step is made from.
fn needed(program: &Program) -> BTreeSet<Value> {
    let margins = program.margins().map(|(_, closed)| closed.margin);
    let margins = margins.filter(|_| program.is_closed());
    let all = program.roots().chain(margins);
    all.filter(|&value| is_made(program.node(value).op))
        .collect()
}

/// Acts that follow each other, in a function of their own.
struct Stage {
    acts: Vec<Act>,
    /// What all of it makes.
    makes: BTreeSet<Value>,
    takes: BTreeSet<Value>,
    gives: Vec<Value>,
    fails: bool,
    takes_sines: bool,
    reads_last: bool,
}

impl Stage {
    /// These acts, which have to give what is needed.
    fn new(acts: Vec<Act>, needed: &BTreeSet<Value>) -> Self {
        let values = |part: fn(&Flow) -> &Vec<Value>| {
            acts.iter().flat_map(move |act| part(&act.flow)).copied()
        };
        let makes: BTreeSet<Value> = values(|flow| &flow.gives).collect();
        let takes = values(|flow| &flow.takes)
            .filter(|value| !makes.contains(value))
            .collect();
        let gives = makes.intersection(needed).copied().collect();
        let [fails, takes_sines, reads_last] = [
            acts.iter().any(|act| act.fails),
            acts.iter().any(|act| act.takes_sines),
            acts.iter().any(|act| act.flow.reads_last),
        ];
        Self {
            acts,
            makes,
            takes,
            gives,
            fails,
            takes_sines,
            reads_last,
        }
    }

    /// The names of values that have one.
    fn names(values: impl IntoIterator<Item = Value>, scope: &mut Scope<'_>) -> Vec<Ident> {
        values.into_iter().map(|value| scope.bind(value)).collect()
    }

    fn function(
        &self,
        program: &Program,
        name: &Ident,
        (number, count): (usize, usize),
        scope: &mut Scope<'_>,
    ) -> TokenStream {
        let (position, scalar) = (position(program), scalar(program));
        let takes = Self::names(self.takes.iter().copied(), scope);
        let gives = Self::names(self.gives.iter().copied(), scope);
        let length = Literal::usize_unsuffixed(gives.len());
        let last = self.reads_last.then(|| quote!(last: &#position,));
        let sines = self.takes_sines.then(|| quote!(<S: Sines<#scalar>>));
        let many = (takes.len() > 6).then(|| {
            quote!(#[allow(clippy::too_many_arguments, reason = "a stage takes what earlier ones have found")])
        });
        let statements = self.acts.iter().map(|act| &act.statements);
        let (result, output) = if self.fails {
            (
                quote!(Ok([#(#gives),*])),
                quote!(Result<[#scalar; #length], Stop>),
            )
        } else {
            (quote!([#(#gives),*]), quote!([#scalar; #length]))
        };
        let doc = format!(" Stage {number} of {count} of a step.");
        quote! {
            #[doc = #doc]
            #many
            #[inline]
            fn #name #sines(#last #(#takes: #scalar),*) -> #output {
                #(#statements)*
                #result
            }
        }
    }

    fn call(&self, name: &Ident, scope: &mut Scope<'_>) -> TokenStream {
        let takes = Self::names(self.takes.iter().copied(), scope);
        let gives = Self::names(self.gives.iter().copied(), scope);
        let last = self.reads_last.then(|| quote!(last,));
        let sines = self.takes_sines.then(|| quote!(::<S>));
        let fails = self.fails.then(|| quote!(?));
        quote!(let [#(#gives),*] = #name #sines(#last #(#takes),*)#fails;)
    }
}
