//! Leading a point by more motors than needed, which go as little as they can.

use super::advance::rates_at;
use super::emitter::Emitter;
use super::led::{Rates, count, given, here};
use super::tokens::integer;
use crate::model::Inverse;
use crate::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

/// The call that leads the point to `place`: an expression in a method.
pub(super) fn lead(emitter: &Emitter<'_>, inverse: &Inverse, moving: &Program) -> TokenStream {
    let there = emitter.at(quote!(at));
    let (given, rates) = (here(&there, inverse), Rates::new(&there, inverse));
    let (velocities, velocity) = (velocities(&there, moving), rates.velocity);
    let (scalar, motors) = (&emitter.scalar, &emitter.motors);
    quote! {
        generated::reach_least(
            Mover {
                position: &mut self.position,
                limits: &known::MOVE_LIMITS,
                step: positions::step,
            },
            inverse::LED,
            place,
            |at| #given,
            |at, rates: [#scalar; #motors]| Result::map(#velocities, |velocities| #velocity),
        )
    }
}

/// The velocities of all links at the position `at`, for the rates of motors `rates`.
fn velocities(emitter: &Emitter<'_>, moving: &Program) -> TokenStream {
    let motors = &emitter.motors;
    if emitter.model.effects.acceleration {
        let found = rates_at(moving, &quote!(*at), &quote!(, rates, [0.0; #motors]));
        quote!(Result::map(#found, |(velocities, _)| velocities))
    } else {
        rates_at(moving, &quote!(*at), &quote!(, rates))
    }
}

/// The module of what is led.
pub(super) fn module(emitter: &Emitter<'_>, inverse: &Inverse) -> TokenStream {
    let (krate, scalar, count) = (emitter.krate, &emitter.scalar, count(inverse));
    let (given, name) = (given(inverse), format!("to `{}`", inverse.name(emitter.model)));
    let motors = inverse.motors.iter().map(|motor| integer(motor.index()));
    let size = emitter.model.size();
    let weights = inverse.motors.iter().map(|motor| {
        let far = emitter.model.unit_of(*motor);
        emitter.number(far * far)
    });
    let (number, size) = (integer(inverse.motors.len()), emitter.number(size));
    quote! {
        /// The point that is led, and the motors that follow.
        mod inverse {
            use #krate::generated::*;

            /// What is given.
            pub(super) const GIVEN: [Input; #count] = #given;

            /// The motors that follow, and how easily they go.
            pub(super) const LED: Surplus<#scalar, #number, #count> = Surplus {
                motors: [#(#motors),*],
                weights: [#(#weights),*],
                given: &GIVEN,
                name: #name,
                size: #size,
            };
        }
    }
}
