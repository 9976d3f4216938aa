//! The function that makes one move: block after block.

use super::block::{function, scalar, statements};
use super::flow::flows;
use super::module;
use super::motion::{given_rates, moved, step_with};
use super::scope::{FunctionNames, Scope, uses};
use super::sensitivity::{followed, sensitivity_step};
use super::stages::{Act, MOST_LETS, in_stages, lets};
use crate::program::{BlockId, BlockKind, Op, Program, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeMap;

/// Straight blocks stand in the main function itself up to this number of values; beyond, each has its own function,
/// because the compiler nests a scope for every `let`.
const MOST_IN_PLACE: usize = 256;

/// In lanes more blocks than this would be more code than it is worth.
const MOST_BLOCKS: usize = 32;

/// The module of a program: the function `step`, and those it calls.
pub(super) fn step(krate: &TokenStream, program: &Program) -> TokenStream {
    let name = module::name(program);
    let program = &*program.divide(MOST_LETS);
    let flows = flows(program);
    let position = position(program);
    let in_place = straight_values(program) <= MOST_IN_PLACE;
    let mut scope = Scope::new(program, all_uses(program));
    if takes_sines(program) {
        scope.take_sines_from(quote!(S::sin_cos));
    }
    let mut motors = motors(program, &mut scope);
    motors.extend(given_rates(program, &mut scope));
    let before = lets(&motors);
    let mut functions = TokenStream::new();
    let mut acts = Vec::new();
    let mut names = FunctionNames::default();
    for block in program.block_ids() {
        let flow = &flows[block.index()];
        if flow.gives.is_empty() {
            continue;
        }
        let kind = &program.blocks[block.index()].kind;
        let straight = matches!(kind, BlockKind::Straight);
        let mut act = Act {
            statements: TokenStream::new(),
            lets: 1,
            flow: flow.clone(),
            fails: matches!(kind, BlockKind::Newton(_)),
            takes_sines: false,
        };
        if straight && in_place {
            act.statements = statements(program, block, flow, &mut scope);
            act.lets = lets(&act.statements);
            act.takes_sines = takes_sines(program);
            acts.push(act);
            continue;
        }
        let name = &program.blocks[block.index()].name;
        let name = scope.fresh_function(&mut names, name);
        functions.extend(function(program, block, &name, flow, &position));
        let last = flow.reads_last.then(|| quote!(last,));
        let takes: Vec<TokenStream> = flow
            .takes
            .iter()
            .map(|&value| scope.expression(value))
            .collect();
        let gives: Vec<Ident> = flow.gives.iter().map(|&value| scope.bind(value)).collect();
        let fails = act.fails.then(|| quote!(?));
        act.statements = quote!(let (#(#gives),*) = #name(#last #(#takes),*)#fails;);
        if let (false, Some(closed)) = (program.is_closed(), program.closed_form(block))
            && program.margins().any(|(other, _)| other == block)
        {
            let (margin, place) = (scope.expression(closed.margin), &closed.place);
            act.statements.extend(quote!(closes([#margin], [#place])?;));
            act.fails = true;
        }
        acts.push(act);
    }
    let (stages, body) = in_stages(program, acts, before, &mut scope, &mut names);
    functions.extend(stages);
    let pose = |values: &[Value; 4]| {
        let [cos, sin, x, y] = values.map(|value| scope.expression(value));
        quote!(Pose { cos: #cos, sin: #sin, x: #x, y: #y })
    };
    let poses: Vec<TokenStream> = program.poses.iter().map(pose).collect();
    let state: Vec<TokenStream> = program
        .state
        .iter()
        .map(|&value| scope.expression(value))
        .collect();
    let is_last = |value: &Value| matches!(program.node(*value).op, Op::Last(_));
    let uses_last = program.state.iter().any(is_last)
        || flows
            .iter()
            .any(|flow| flow.reads_last && !flow.gives.is_empty());
    let last = if uses_last { quote!(last) } else { quote!(_) };
    let (margins, places): (Vec<TokenStream>, Vec<&String>) = program
        .margins()
        .map(|(_, closed)| (scope.expression(closed.margin), &closed.place))
        .unzip();
    let result = quote!(Position { motors, poses: [#(#poses),*], state: [#(#state),*] });
    let moved = program.motion.as_ref().map(|motion| moved(motion, &scope));
    let written = Written {
        motors,
        body,
        last,
        result,
        margins,
    };
    let steps = if let (Some(sensitivity), Some(moved)) = (&program.sensitivity, &moved) {
        let followed = followed(sensitivity, &scope);
        sensitivity_step(program, &written, &places, (moved, &followed))
    } else if let Some(moved) = moved {
        step_with(program, &written, &places, &moved)
    } else if program.is_closed() {
        closed_step(program, &written, &places)
    } else {
        iterated_step(program, &written)
    };
    module::module(krate, &name, &quote!(#functions #steps))
}

/// What a step is made of.
pub(super) struct Written {
    pub(super) motors: TokenStream,
    pub(super) body: TokenStream,
    /// The parameter for the last position.
    pub(super) last: TokenStream,
    /// The new position.
    pub(super) result: TokenStream,
    pub(super) margins: Vec<TokenStream>,
}

/// A step whose loops are all in closed form: the position, whether or not they close, and a function that asks.
fn closed_step(program: &Program, written: &Written, places: &[&String]) -> TokenStream {
    let Written {
        motors,
        body,
        last,
        result,
        margins,
    } = written;
    let (position, scalar) = (position(program), scalar(program));
    let [count, loops] = [program.inputs(), margins.len()].map(Literal::usize_unsuffixed);
    let (sines, anywhere, step_reduced) = if takes_sines(program) {
        let step_reduced = quote! {
            /// The same, where all angles are within the range of the polynomials of sine and cosine.
            #[inline]
            pub(super) fn step_reduced(last: &#position, motors: Motors<#scalar, #count>) -> Result<#position, Stop> {
                let (position, margins) = position::<Reduced>(last, motors);
                closes(margins, [#(#places),*])?;
                Ok(position)
            }
        };
        (
            quote!(<S: Sines<#scalar>>),
            quote!(::<FullRange>),
            step_reduced,
        )
    } else {
        (TokenStream::new(), TokenStream::new(), TokenStream::new())
    };
    quote! {
        /// The position at these motor values, and for each loop a margin: it closes if that is not negative.
        #[inline(always)]
        pub(super) fn position #sines(#last: &#position, motors: Motors<#scalar, #count>) -> (#position, [#scalar; #loops]) {
            #motors
            #body
            (#result, [#(#margins),*])
        }

        /// The position at these motor values, if every loop closes there.
        #[inline]
        pub(super) fn step(last: &#position, motors: Motors<#scalar, #count>) -> Result<#position, Stop> {
            let (position, margins) = position #anywhere(last, motors);
            closes(margins, [#(#places),*])?;
            Ok(position)
        }

        #step_reduced
    }
}

/// A step with iterations in it.
fn iterated_step(program: &Program, written: &Written) -> TokenStream {
    let Written {
        motors,
        body,
        last,
        result,
        ..
    } = written;
    let (position, scalar) = (position(program), scalar(program));
    let count = Literal::usize_unsuffixed(program.inputs());
    quote! {
        /// The position at these motor values, close to the last one.
        pub(super) fn step(#last: &#position, motors: Motors<#scalar, #count>) -> Result<#position, Stop> {
            #motors
            #body
            Ok(#result)
        }
    }
}

/// The type of a position of this mechanism.
pub(super) fn position(program: &Program) -> TokenStream {
    let scalar = scalar(program);
    let sizes = [
        program.inputs(),
        program.start.poses.len(),
        program.start.state.len(),
    ]
    .map(Literal::usize_unsuffixed);
    quote!(Position<#scalar, #(#sizes),*>)
}

/// What a mechanism's motors are given, as variables: for each a value, and where something needs them its whole turns.
fn motors(program: &Program, scope: &mut Scope<'_>) -> TokenStream {
    let value = |wanted: Op| {
        program
            .live_values()
            .find(|&value| program.node(value).op == wanted)
    };
    let variable = |(motor, name): (usize, &String)| match value(Op::Motor(motor)) {
        Some(value) => scope.bind(value),
        None => scope.fresh(&format!("_{name}")),
    };
    let variables: Vec<Ident> = program.input_names().enumerate().map(variable).collect();
    let mut tokens = TokenStream::new();
    let mut read = format_ident!("motors");
    if program.reduces() {
        read = scope.fresh("reduced");
        let turning = &program.reduced;
        tokens.extend(quote!(let #read = motors.reduced(&[#(#turning),*]);));
    }
    tokens.extend(quote!(let [#(#variables),*] = #read.values;));
    let (mut names, mut all) = (Vec::new(), Vec::new());
    for value in program.live_values() {
        let made = match program.node(value).op {
            Op::Turns(motor) => {
                let (motor, scalar) = (Literal::usize_unsuffixed(motor), scalar(program));
                quote!(<#scalar as Real>::from_i32(#read.turns[#motor]))
            }
            Op::Turned(motor, numerator, denominator) => {
                let (motor, scalar) = (Literal::usize_unsuffixed(motor), scalar(program));
                let (numerator, denominator) = (
                    Literal::i64_unsuffixed(numerator),
                    Literal::i64_unsuffixed(denominator),
                );
                quote!(turned::<#scalar>(#read.turns[#motor], #numerator, #denominator))
            }
            _ => continue,
        };
        names.push(scope.bind(value));
        all.push(made);
    }
    if names.len() <= MOST_LETS / 2 {
        tokens.extend(quote!(#(let #names = #all;)*));
    } else {
        tokens.extend(quote!(let [#(#names),*] = [#(#all),*];));
    }
    tokens
}

/// Whether many positions are computed in lanes: where each is a function of the motors, and not too long.
pub(super) fn in_lanes(program: &Program) -> bool {
    let of_motors_alone = program.is_function() && program.params.is_empty();
    of_motors_alone && takes_sines(program) && program.blocks.len() <= MOST_BLOCKS
}

/// Whether the positions are written once for any place that sines and cosines are taken from: where all of those stand in one
/// function, and none is of an angle that a param may make as large as it likes.
pub(super) fn takes_sines(program: &Program) -> bool {
    !program.curved
        && program.is_closed()
        && straight_values(program) <= MOST_IN_PLACE
        && !turns_by_params(program)
}

/// Whether a sine or cosine is of something that depends on a param.
fn turns_by_params(program: &Program) -> bool {
    if program.params.is_empty() {
        return false;
    }
    let dependent = program.dependent();
    let is_dependent = |value: Value| match program.node(value).op {
        Op::Sin(angle) | Op::Cos(angle) => dependent[angle.index()],
        _ => false,
    };
    program.live_values().any(is_dependent)
}

fn straight_values(program: &Program) -> usize {
    let straight =
        |block: BlockId| matches!(program.blocks[block.index()].kind, BlockKind::Straight);
    program
        .live_values()
        .filter(|&value| straight(program.node(value).block))
        .count()
}

/// The uses of values within the straight blocks, which share one function.
fn all_uses(program: &Program) -> BTreeMap<Value, usize> {
    let mut all = BTreeMap::new();
    for block in program.block_ids() {
        for (value, count) in uses(program, block) {
            *all.entry(value).or_insert(0) += count;
        }
    }
    let margins = program.margins().map(|(_, closed)| closed.margin);
    for value in program.roots().chain(margins) {
        *all.entry(value).or_insert(0) += 1;
    }
    all
}
