//! What the struct of a mechanism has more if motors follow laws.

use super::added::Added;
use super::block::{binding, function, scalar};
use super::flow::flows;
use super::items::ending_with;
use super::module;
use super::moves::step_reduced;
use super::params;
use super::rates::moved_with;
use super::scope::{FunctionNames, Scope, uses};
use super::stages::MOST_LETS;
use super::step::position;
use crate::bug::bug;
use crate::compiled::Compiled;
use crate::model::{JointKind, Model, Precision};
use crate::program::{Program, Timed, Timing, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeMap;

/// What laws add to a mechanism. `rest` is what rates leave behind after a move without them.
pub(super) fn added(
    krate: &TokenStream,
    model: &Model,
    compiled: &Compiled,
    visibility: &syn::Visibility,
    (standstill, record): (&TokenStream, &TokenStream),
) -> Added {
    let Some(timing) = &compiled.timing else {
        return Added::default();
    };
    Added {
        methods: at_time(model, compiled, visibility, (standstill, record)),
        steps: laws(krate, model, &compiled.program, timing),
        ..Added::default()
    }
}

/// The method that moves the motors by their laws.
fn at_time(
    model: &Model,
    compiled: &Compiled,
    visibility: &syn::Visibility,
    (standstill, record): (&TokenStream, &TokenStream),
) -> TokenStream {
    let program = &compiled.program;
    let (scalar, step_reduced) = (scalar(program), step_reduced(program));
    let count = Literal::usize_unsuffixed(program.motors.len());
    let written = model.lawful_motors().map(|(motor, law)| {
        let joint = &model.joint(model.motor(motor).joint).name;
        format!("`{joint} = {}`", law.written)
    });
    let written: Vec<String> = written.collect();
    let doc = format!(
        " Moves the motors that follow laws to where these have them at a time, and everything accordingly: {}.",
        written.join(", ")
    );
    let others = if written.len() < program.motors.len() {
        quote!(#[doc = " The other motors stay where they are."])
    } else {
        TokenStream::new()
    };
    let Some((first, _)) = model.lawful_motors().next() else {
        bug!("there is a timing without a law");
    };
    let first = Literal::usize_unsuffixed(first.index());
    let effects = model.effects;
    let found = match (effects.velocity, effects.acceleration) {
        (false, _) => quote!(motors),
        (true, false) => quote!((motors, rates)),
        (true, true) => quote!((motors, rates, accelerations)),
    };
    let moved = match &compiled.moving {
        Some(moving) => moved_with(moving, effects, &quote!(motors), record),
        None => ending_with(
            params::of_motors(
                program,
                quote!(generated::advance(&mut self.position, motors, &known::MOVE_LIMITS, #step_reduced, positions::step)),
            ),
            &quote!(#standstill #record),
        ),
    };
    let refused = params::refused(program);
    let dead = if effects.velocity {
        quote! {
            #[doc = " If the time, or the value or a rate of a law at it, is not a finite number, a loop cannot be closed on the"]
            #[doc = " way there, or it is at a dead point or a change point there, where rates are not determined; the mechanism"]
            #[doc = " then stays where it was."]
        }
    } else {
        quote! {
            #[doc = " If the time, or the value of a law at it, is not a finite number, or a loop cannot be closed on the way"]
            #[doc = " there; the mechanism then stays where it was."]
        }
    };
    quote! {
        #[doc = #doc]
        #others
        ///
        /// # Errors
        #dead
        #visibility fn at_time(&mut self, t: f64) -> Result<(), Blocked<[#scalar; #count]>> {
            let there = generated::finite([t], &[known::MOVE_LIMITS.inputs[#first]])
                .and_then(|()| laws::laws(self.position.motors, t));
            let #found = match there {
                Result::Ok(there) => there,
                Result::Err(stop) => return Result::Err(#refused),
            };
            #moved
        }
    }
}

/// The laws as a function.
fn laws(krate: &TokenStream, model: &Model, program: &Program, timing: &Timing) -> TokenStream {
    let written = &*timing.program.divide(MOST_LETS);
    let mut scope = Scope::new(written, all_uses(written));
    let time = scope.fresh("t");
    let motors = Literal::usize_unsuffixed(program.motors.len());
    let mut params = TokenStream::new();
    for (param, value) in timing.used_params() {
        let name = scope.bind(value);
        let index = Literal::usize_unsuffixed(program.motors.len() + param.index());
        params.extend(quote!(let #name = Real::to_f64(motors.values[#index]);));
    }
    let used = timing.time();
    if let Some(value) = used {
        scope.alias(value, time.clone());
    }
    let (parts, mut body) = if written.blocks.len() > 1 {
        in_parts(written, &mut scope)
    } else {
        (TokenStream::new(), in_place(written, &mut scope))
    };
    let scalar = scalar(program);
    let count = Literal::usize_unsuffixed(program.inputs());
    for timed in &timing.motors {
        body.extend(follow(model, program, timed, &scope));
    }
    let rates = |part: fn(&Timed) -> Option<Value>| {
        let rate = |motor: usize| {
            let mut timed = timing.motors.iter();
            let timed = timed.find(|timed| timed.motor.index() == motor);
            match (timed.and_then(part), program.precision) {
                (None, _) => quote!(0.0),
                (Some(rate), Precision::F64) => scope.expression(rate),
                (Some(rate), Precision::F32) => {
                    let rate = scope.expression(rate);
                    quote!(<f32 as Real>::from_f64(#rate))
                }
            }
        };
        let rates = (0..program.motors.len()).map(rate);
        quote!([#(#rates),*])
    };
    let [first, second] = [rates(|timed| timed.rate), rates(|timed| timed.second)];
    let given = quote!([#scalar; #motors]);
    let motors = quote!(Motors<#scalar, #count>);
    let (kind, result) = match (model.effects.velocity, model.effects.acceleration) {
        (false, _) => (motors.clone(), quote!(motors)),
        (true, false) => (quote!((#motors, #given)), quote!((motors, #first))),
        (true, true) => (
            quote!((#motors, #given, #given)),
            quote!((motors, #first, #second)),
        ),
    };
    let time = used.map_or_else(|| quote!(_), |_| quote!(#time));
    let functions = quote! {
        #parts

        /// The motors at a time, by their laws.
        #[inline]
        pub(super) fn laws(mut motors: #motors, #time: f64) -> Result<#kind, Stop> {
            #params
            #body
            Ok(#result)
        }
    };
    module::module(krate, &format_ident!("laws"), &functions)
}

/// Everything that laws say, as statements.
fn in_place(written: &Program, scope: &mut Scope<'_>) -> TokenStream {
    let mut tokens = TokenStream::new();
    for value in written.live_values() {
        if !scope.is_bound(value) && scope.deserves_name(value) {
            tokens.extend(binding(written, value, scope));
        }
    }
    tokens
}

/// The same as functions, and the statements that call them.
fn in_parts(written: &Program, scope: &mut Scope<'_>) -> (TokenStream, TokenStream) {
    let (mut functions, mut calls) = (TokenStream::new(), TokenStream::new());
    let flows = flows(written);
    let mut names = FunctionNames::default();
    for (number, (block, flow)) in written.block_ids().zip(&flows).enumerate() {
        let name = scope.fresh_function(&mut names, &format!("laws_part_{}", number + 1));
        functions.extend(function(written, block, &name, flow, &position(written)));
        let [takes, gives] = [&flow.takes, &flow.gives].map(|values| -> Vec<Ident> {
            values.iter().map(|&value| scope.bind(value)).collect()
        });
        calls.extend(quote!(let (#(#gives),*) = #name(#(#takes),*);));
    }
    (functions, calls)
}

/// The statement that gives a motor the value of its law.
fn follow(model: &Model, program: &Program, timed: &Timed, scope: &Scope<'_>) -> TokenStream {
    let motor = timed.motor;
    let (index, name) = (
        Literal::usize_unsuffixed(motor.index()),
        &program.motors[motor.index()],
    );
    let value = scope.expression(timed.value);
    let turns = matches!(
        model.joint(model.motor(motor).joint).kind,
        JointKind::Revolute(..)
    );
    // Single precision has no digits for many turns and a part of one.
    if turns && program.precision == Precision::F32 {
        quote!(motors.turn_by(#index, #value, #name)?;)
    } else {
        quote!(motors.follow(#index, #value, #name)?;)
    }
}

/// How often each value is used by others, and how often it is given.
fn all_uses(program: &Program) -> BTreeMap<Value, usize> {
    let mut all: BTreeMap<Value, usize> = BTreeMap::new();
    for block in program.block_ids() {
        for (value, count) in uses(program, block) {
            *all.entry(value).or_insert(0) += count;
        }
    }
    for value in &program.state {
        *all.entry(*value).or_insert(0) += 1;
    }
    all
}
