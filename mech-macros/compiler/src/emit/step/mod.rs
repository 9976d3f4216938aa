//! The functions of a program: its step, and those that the step calls.

mod alike;
mod binding;
mod block;
mod flow;
mod functions;
mod inputs;
mod iteration;
mod laws;
mod outcome;
mod runs;
mod scope;
mod sensitivity;
mod sines;
mod stages;

pub(super) use inputs::{arguments, parameters};
pub(super) use laws::laws;
pub(super) use outcome::outcome_type;
pub(super) use sines::{runs_in_lanes, takes_sines};

use super::module;
use crate::program::{BlockId, BlockKind, Op, Program, Value};
use block::{function, statements};
use flow::{Flow, flows};
use functions::{Margins, StepParts, lanes_function, step_functions};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use runs::Gathered;
use scope::Scope;
use sensitivity::sensitivity_functions;
use stages::{Act, Body, MOST_LETS, body, count_lets};
use std::collections::{BTreeMap, BTreeSet};

/// The module of a program: the function `step`, and those it calls. Where many positions are computed in lanes, loops that are alike
/// are computed side by side for one position only: for many there is a module of its own.
pub(super) fn step(krate: &TokenStream, program: &Program) -> TokenStream {
    let name = module::name(program);
    let program = &*program.divide(MOST_LETS);
    let own = module::module(krate, &name, &functions(program, Purpose::Step));
    if name == "positions" && name != lanes_module(program) {
        let lanes = functions(program, Purpose::Lanes);
        let lanes = module::module(krate, &lanes_module(program), &lanes);
        return quote!(#own #lanes);
    }
    own
}

/// The module whose function `position` computes many positions in lanes.
pub(super) fn lanes_module(program: &Program) -> Ident {
    if runs_in_lanes(program) && alike::has_alike(program) {
        format_ident!("lanes")
    } else {
        format_ident!("positions")
    }
}

/// The purpose of the functions of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Purpose {
    /// To find what a program computes.
    Step,
    /// To find many positions, each as one of several lanes.
    Lanes,
}

/// The functions of a program.
fn functions(program: &Program, purpose: Purpose) -> TokenStream {
    let flows = flows(program);
    let sin_cos = if takes_sines(program) { quote!(S::sin_cos) } else { quote!(sin_cos) };
    let mut scope = Scope::new(program, all_uses(program), sin_cos);
    let inputs = inputs::inputs(&mut scope);
    let mut names = BTreeSet::new();
    let shared = match purpose {
        Purpose::Step => alike::blocks(&mut scope, &mut names),
        Purpose::Lanes => None,
    };
    let Blocks { acts, functions } =
        shared.unwrap_or_else(|| blocks(&flows, &mut scope, &mut names));
    let Body { statements, functions: stages } =
        body(acts, count_lets(&inputs), &mut scope, &mut names);
    let is_last = |value: &Value| matches!(program.node(*value).op, Op::Last(_));
    let mut run = flows.iter().filter(|flow| !flow.gives.is_empty());
    let reads_last = program.state.iter().any(is_last) || run.any(|flow| flow.reads_last);
    let (poses, margins_in_loops) = (poses(&mut scope), margins_in_loops(&mut scope));
    let gathered: TokenStream = [&poses, &margins_in_loops]
        .into_iter()
        .flatten()
        .map(|gathered| gathered.statements.clone())
        .collect();
    let parts = StepParts {
        last: if reads_last { quote!(last) } else { quote!(_) },
        statements: quote!(#inputs #statements #gathered),
        position: position(&scope, poses.as_ref()),
        margins: margins(&scope, margins_in_loops.as_ref()),
        rate_margins: rate_margins(&scope),
    };
    let steps = match (program.sensitivity(), purpose) {
        (_, Purpose::Lanes) => lanes_function(&parts, program),
        (Some(sensitivity), Purpose::Step) => sensitivity_functions(sensitivity, &parts, &scope),
        (None, Purpose::Step) => step_functions(&parts, &scope),
    };
    quote!(#functions #stages #steps)
}

/// The blocks of a step.
struct Blocks {
    acts: Vec<Act>,
    /// The functions of those blocks that do not stand in the step itself.
    functions: TokenStream,
}

/// The statements of each block that is run.
fn blocks(flows: &[Flow], scope: &mut Scope<'_>, names: &mut BTreeSet<String>) -> Blocks {
    let program = scope.program;
    let (mut acts, mut functions) = (Vec::new(), TokenStream::new());
    for (id, flow) in program.block_ids().zip(flows) {
        if !flow.gives.is_empty() {
            acts.push(whole_block(id, flow, scope, names, &mut functions));
        }
    }
    Blocks { acts, functions }
}

/// The statements of a block. If it has a function of its own, this is added to `functions`.
fn whole_block(
    id: BlockId,
    flow: &Flow,
    scope: &mut Scope<'_>,
    names: &mut BTreeSet<String>,
    functions: &mut TokenStream,
) -> Act {
    let program = scope.program;
    let block = &program.ssa.blocks[id.index()];
    let mut act = Act {
        statements: TokenStream::new(),
        lets: 1,
        flow: flow.clone(),
        fails: matches!(block.kind, BlockKind::Newton(_)),
        takes_sines: false,
    };
    if matches!(block.kind, BlockKind::Straight) && sines::is_short(program) {
        act.statements = statements(id, flow, scope);
        act.lets = count_lets(&act.statements);
        act.takes_sines = takes_sines(program);
        return act;
    }
    let name = scope.fresh_function(names, &block.name);
    let gives: Vec<Value> = flow.gives.iter().copied().collect();
    functions.extend(function(program, id, &name, flow, &gives, &quote!(inline)));
    let last = flow.reads_last.then(|| quote!(last,));
    let takes = scope.expressions(&flow.takes);
    let gives = scope.bind_all(&flow.gives);
    let fails = act.fails.then(|| quote!(?));
    act.statements = quote!(let (#(#gives),*) = #name(#last #(#takes),*)#fails;);
    if let (false, Some(closed)) = (program.is_closed(), program.closed_form(id))
        && program.margins().any(|(other, _)| other == id)
    {
        let (margin, place) = (scope.expression(closed.margin), &closed.place);
        act.statements.extend(quote!(closes([#margin], [#place])?;));
        act.fails = true;
    }
    act
}

/// The poses, if loops put them together.
fn poses(scope: &mut Scope<'_>) -> Option<Gathered> {
    let pose = |parts: &[TokenStream]| {
        let names = ["cos", "sin", "x", "y"].map(|name| format_ident!("{name}"));
        quote!(Pose { #(#names: #parts),* })
    };
    let zero = pose(&[0, 1, 2, 3].map(|_| quote!(0.0)));
    Gathered::of("poses", &scope.program.poses, &zero, pose, scope)
}

/// The margins of loops, if loops put them together.
fn margins_in_loops(scope: &mut Scope<'_>) -> Option<Gathered> {
    let margins = scope.program.margins();
    let margins: Vec<[Value; 1]> = margins.map(|(_, closed)| [closed.margin]).collect();
    let margin = |parts: &[TokenStream]| quote!(#(#parts)*);
    Gathered::of("margins", &margins, &quote!(0.0), margin, scope)
}

/// The margins by which loops close.
fn margins<'p>(scope: &Scope<'p>, gathered: Option<&Gathered>) -> Margins<'p> {
    let margins = scope.program.margins();
    let margins: Margins<'p> = margins
        .map(|(_, closed)| (scope.expression(closed.margin), closed.place.as_str()))
        .collect();
    match gathered {
        Some(gathered) => margins.in_array(&gathered.array),
        None => margins,
    }
}

/// The position that a step ends with.
fn position(scope: &Scope<'_>, gathered: Option<&Gathered>) -> TokenStream {
    let state = scope.expressions(&scope.program.state);
    if let Some(Gathered { array, .. }) = gathered {
        return quote!(Position { motors, poses: #array, state: [#(#state),*] });
    }
    let poses = scope.program.poses.iter().map(|pose| {
        let [cos, sin, x, y] = pose.map(|value| scope.expression(value));
        quote!(Pose { cos: #cos, sin: #sin, x: #x, y: #y })
    });
    quote!(Position { motors, poses: [#(#poses),*], state: [#(#state),*] })
}

/// The margins by which rates are determined.
fn rate_margins<'p>(scope: &Scope<'p>) -> Margins<'p> {
    let margins = scope.program.rate_margins().iter();
    margins.map(|margin| (scope.expression(margin.margin), margin.place.as_str())).collect()
}

/// The number of uses of each value, where all blocks stand in one function.
fn all_uses(program: &Program) -> BTreeMap<Value, usize> {
    let mut all = uses_in(program, |_| true);
    let margins = program.margins().map(|(_, closed)| closed.margin);
    for value in program.roots().chain(margins) {
        *all.entry(value).or_insert(0) += 1;
    }
    all
}

/// The number of uses of each value within a block.
fn uses(program: &Program, block: BlockId) -> BTreeMap<Value, usize> {
    uses_in(program, |other| other == block)
}

/// The number of uses of each value within some blocks.
fn uses_in(program: &Program, is_in: impl Fn(BlockId) -> bool) -> BTreeMap<Value, usize> {
    let mut uses = BTreeMap::new();
    let mut count = |value: Value| *uses.entry(value).or_insert(0) += 1;
    let nodes = program.live_values().map(|value| program.node(value));
    for node in nodes.filter(|node| is_in(node.block)) {
        node.op.operands().for_each(&mut count);
    }
    let systems = program.live_systems();
    for system in systems.filter(|system| is_in(system.block)) {
        system.coefficients().copied().for_each(&mut count);
    }
    let blocks = program.block_ids().filter(|block| is_in(*block));
    for newton in blocks.filter_map(|block| program.newton(block)) {
        // The gap and the determinant leave the iteration; the next values are read once.
        let columns = newton.columns.iter().flatten();
        let columns = columns.filter(|_| newton.dense);
        let gap = newton.gap.iter().copied();
        gap.chain([newton.det]).chain(newton.extent).chain(columns.copied()).for_each(&mut count);
        let scalars = newton.scalars.iter();
        scalars.flat_map(|scalar| [scalar.first, scalar.next]).for_each(&mut count);
    }
    uses
}
