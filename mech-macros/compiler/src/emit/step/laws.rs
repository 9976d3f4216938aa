//! The laws of the motors as a function of time.

use super::all_uses;
use super::binding::binding;
use super::block::function;
use super::flow::flows;
use super::inputs::motors_type;
use super::scope::Scope;
use super::stages::MOST_LETS;
use crate::emit::emitter::Emitter;
use crate::emit::module;
use crate::emit::tokens::integer;
use crate::model::Precision;
use crate::program::{LawValues, Timing, Value};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use std::collections::BTreeSet;

/// The module of the function `laws`: at a time, the motors and if they are asked for their rates and accelerations.
pub(in crate::emit) fn laws(emitter: &Emitter<'_>, timing: &Timing) -> TokenStream {
    let Emitter { model, program, values, .. } = emitter;
    let laws = &*timing.program.divide(MOST_LETS);
    let mut scope = Scope::new(laws, all_uses(laws), quote!(sin_cos));
    let mut time = scope.fresh("t");
    let mut body = TokenStream::new();
    for (param, value) in timing.used_params() {
        let name = scope.bind(value);
        let index = integer(program.motors.len() + param.index());
        body.extend(quote!(let #name = Real::to_f64(motors.values[#index]);));
    }
    match timing.time() {
        Some(value) => scope.alias(value, time.clone()),
        None => time = format_ident!("_"),
    }
    let mut functions = TokenStream::new();
    if laws.ssa.blocks.len() > 1 {
        functions = part_functions(&mut scope, &mut body);
    } else {
        body.extend(statements(&mut scope));
    }
    for timed in &timing.motors {
        body.extend(follow(emitter, timed, &scope));
    }
    let rates = |part: fn(&LawValues) -> Option<Value>| {
        let rates = model.motor_ids().map(|motor| {
            let mut timed = timing.motors.iter();
            let timed = timed.find(|timed| timed.motor == motor);
            match (timed.and_then(part), program.precision) {
                (None, _) => quote!(0.0),
                (Some(rate), Precision::F64) => scope.expression(rate),
                (Some(rate), Precision::F32) => {
                    let rate = scope.expression(rate);
                    quote!(<f32 as Real>::from_f64(#rate))
                }
            }
        });
        quote!([#(#rates),*])
    };
    let motors = motors_type(program);
    let (mut kind, mut result) = (quote!(#motors), quote!(motors));
    let is_asked = |part: fn(&LawValues) -> Option<Value>| {
        timing.motors.iter().any(|timed| part(timed).is_some())
    };
    if is_asked(|timed| timed.rate) {
        let rates = rates(|timed| timed.rate);
        kind.extend(quote!(, #values));
        result.extend(quote!(, #rates));
    }
    if is_asked(|timed| timed.second) {
        let accelerations = rates(|timed| timed.second);
        kind.extend(quote!(, #values));
        result.extend(quote!(, #accelerations));
    }
    if is_asked(|timed| timed.rate) {
        (kind, result) = (quote!((#kind)), quote!((#result)));
    }
    let functions = quote! {
        #functions

        /// The motors at a time, by their laws.
        #[inline]
        pub(super) fn laws(mut motors: #motors, #time: f64) -> Result<#kind, Stop> {
            #body
            Ok(#result)
        }
    };
    module::module(emitter.krate, &format_ident!("laws"), &functions)
}

/// The statements that compute all laws.
fn statements(scope: &mut Scope<'_>) -> TokenStream {
    let mut tokens = TokenStream::new();
    for value in scope.program.live_values() {
        if !scope.is_bound(value) && scope.deserves_name(value) {
            tokens.extend(binding(value, scope));
        }
    }
    tokens
}

/// Functions that compute parts of all laws. The statements that call them go to `body`.
fn part_functions(scope: &mut Scope<'_>, body: &mut TokenStream) -> TokenStream {
    let (laws, mut functions) = (scope.program, TokenStream::new());
    let mut names = BTreeSet::new();
    for ((block, flow), number) in laws.block_ids().zip(flows(laws)).zip(1..) {
        let name = scope.fresh_function(&mut names, &format!("laws_part_{number}"));
        let gives: Vec<Value> = flow.gives.iter().copied().collect();
        functions.extend(function(laws, block, &name, &flow, &gives, &quote!(inline)));
        let (takes, gives) = (scope.bind_all(&flow.takes), scope.bind_all(&flow.gives));
        body.extend(quote!(let (#(#gives),*) = #name(#(#takes),*);));
    }
    functions
}

/// The statement that gives a motor the value of its law.
fn follow(emitter: &Emitter<'_>, timed: &LawValues, scope: &Scope<'_>) -> TokenStream {
    let (motor, program) = (timed.motor, emitter.program);
    let (index, name) = (integer(motor.index()), &program.motors[motor.index()]);
    let value = scope.expression(timed.value);
    // Single precision has no digits for many turns and a part of one.
    if emitter.turns(motor) && program.precision == Precision::F32 {
        quote!(motors.turn_by(#index, #value, #name)?;)
    } else {
        quote!(motors.follow(#index, #value, #name)?;)
    }
}
