//! Calls of the runtime functions that move a mechanism. To them a param is an input after the motors; to users, motors and params are
//! apart.

use super::emitter::Emitter;
use super::module;
use super::step::{arguments, takes_sines};
use crate::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

/// The path of a program's step for motors within the reduced range.
pub(super) fn step_reduced(program: &Program) -> TokenStream {
    let module = module::name(program);
    if takes_sines(program) { quote!(#module::step_reduced) } else { quote!(#module::step) }
}

/// The move of a position to `target`.
pub(super) fn advance(
    emitter: &Emitter<'_>,
    position: &TokenStream,
    target: &TokenStream,
) -> TokenStream {
    let step_reduced = step_reduced(emitter.program);
    quote!(generated::advance(&mut #position, #target, &known::MOVE_LIMITS, #step_reduced, positions::step))
}

/// The move of `position`, a reference, to `target`: it gives the rates or forces that a derived program computes there.
pub(super) fn advance_with(
    derived: &Program,
    position: &TokenStream,
    target: &TokenStream,
) -> TokenStream {
    let (module, step_reduced) = (module::name(derived), step_reduced(derived));
    let arguments = arguments(derived);
    quote! {
        generated::advance_with(
            #position,
            #target,
            &known::MOVE_LIMITS,
            |last, motors| #step_reduced(last, motors #arguments),
            |last, motors| #module::step(last, motors #arguments),
            positions::step,
        )
    }
}

/// The rates or forces that a derived program computes at a position.
pub(super) fn rates_at(
    derived: &Program,
    position: &TokenStream,
    arguments: &TokenStream,
) -> TokenStream {
    let module = module::name(derived);
    quote! {
        generated::rates_at(
            &#position,
            &known::MOVE_LIMITS,
            |last, motors| #module::step(last, motors #arguments),
            positions::step,
        )
    }
}

/// The forces that a derived program computes where the mechanism is, by the variables that are named as its parameters.
pub(super) fn forces_here(derived: &Program) -> TokenStream {
    rates_at(derived, &quote!(self.position), &arguments(derived))
}

/// The target of a move to the variable `motors`, with the params of a position.
pub(super) struct Target {
    /// The statement before the move.
    pub(super) before: TokenStream,
    pub(super) value: TokenStream,
}

impl Target {
    pub(super) fn new(emitter: &Emitter<'_>, position: &TokenStream) -> Self {
        if emitter.has_params() {
            Self {
                before: quote!(let motors = generated::inputs(motors, &#position.motors);),
                value: quote!(motors),
            }
        } else {
            Self { before: TokenStream::new(), value: quote!(Motors::new(motors)) }
        }
    }
}

/// The result of a move, with motors alone in its error.
pub(super) fn strip_params(emitter: &Emitter<'_>, result: TokenStream) -> TokenStream {
    if emitter.has_params() { quote!(#result.map_err(generated::blocked_motors)) } else { result }
}

/// The error of a mechanism that stays where it is because of the variable `stop`.
pub(super) fn refusal(emitter: &Emitter<'_>) -> TokenStream {
    refusal_by(emitter, &quote!(stop))
}

/// The same with an expression for `stop`.
pub(super) fn refusal_by(emitter: &Emitter<'_>, stop: &TokenStream) -> TokenStream {
    let refusal = quote!(Position::refuse(&self.position, #stop, known::MOVE_LIMITS.inputs));
    if emitter.has_params() { quote!(generated::blocked_motors(#refusal)) } else { refusal }
}

/// The statements after a move without rates: everything stands still, and points are traced.
pub(super) fn end(emitter: &Emitter<'_>) -> TokenStream {
    let (standstill, record) = (standstill(emitter, &quote!(self)), record(emitter));
    quote!(#standstill #record)
}

/// A move without rates, and the statements after it.
pub(super) fn with_end(emitter: &Emitter<'_>, advance: TokenStream) -> TokenStream {
    let end = end(emitter);
    if end.is_empty() {
        return advance;
    }
    quote! {
        let moved = #advance?;
        #end
        Result::Ok(moved)
    }
}

/// The statements that set the rates of an instance to zero.
pub(super) fn standstill(emitter: &Emitter<'_>, instance: &TokenStream) -> TokenStream {
    let Emitter { links, motors, .. } = emitter;
    let effects = emitter.model.effects;
    let velocities =
        effects.velocity.then(|| quote!(#instance.velocities = [Velocity::ZERO; #links];));
    let accelerations = effects
        .acceleration
        .then(|| quote!(#instance.accelerations = [Acceleration::ZERO; #links];));
    let rates = effects.dynamics.then(|| quote!(#instance.rates = [0.0; #motors];));
    quote!(#velocities #accelerations #rates)
}

/// The statement that stores the places of traced points; nothing without traces.
pub(super) fn record(emitter: &Emitter<'_>) -> Option<TokenStream> {
    (!emitter.model.traces.is_empty()).then(|| quote!(Traced::record(self);))
}
