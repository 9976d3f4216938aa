//! What params add: the methods that tell and set them, and where points are that depend on them. Inside, a param is an input after
//! the motors; outside, motors and params are apart.

use super::added::Added;
use super::block::scalar;
use super::items::{ending_with, user_ident};
use super::moves::step_reduced;
use super::scope::number;
use super::sensitivity;
use super::step::step;
use crate::compiled::Compiled;
use crate::model::{AxisId, Model};
use crate::program::Program;
use crate::syntax::Places;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The target of a move to values of the motors, with the params as they are at this position, and what stands before the move.
pub(super) fn target(program: &Program, position: &TokenStream) -> [TokenStream; 2] {
    if program.params.is_empty() {
        [quote!(Motors::new(motors)), TokenStream::new()]
    } else {
        [
            quote!(motors),
            quote!(let motors = generated::inputs(motors, &#position.motors);),
        ]
    }
}

/// The result of a move, as it is told outside.
pub(super) fn of_motors(program: &Program, result: TokenStream) -> TokenStream {
    if program.params.is_empty() {
        result
    } else {
        quote!(#result.map_err(generated::blocked_motors))
    }
}

/// The message that a mechanism stays where it is, as it is told outside.
pub(super) fn refused(program: &Program) -> TokenStream {
    refused_by(program, &quote!(stop))
}

/// The same, with what stops it.
pub(super) fn refused_by(program: &Program, stop: &TokenStream) -> TokenStream {
    if program.params.is_empty() {
        quote!(Position::refuse(&self.position, #stop, known::MOVE_LIMITS.inputs))
    } else {
        quote!(generated::blocked_motors(Position::refuse(&self.position, #stop, known::MOVE_LIMITS.inputs)))
    }
}

/// The values of the motors among all that is given.
pub(super) fn motors(program: &Program) -> TokenStream {
    if program.params.is_empty() {
        quote!(Motors::total(&self.position.motors))
    } else {
        quote!(generated::motors_of(Motors::total(&self.position.motors)))
    }
}

/// What params and the sensitivity to them add to a mechanism. `end` is what every move that has no rates ends with.
pub(super) fn added(
    krate: &TokenStream,
    places: &Places,
    model: &Model,
    compiled: &Compiled,
    visibility: &syn::Visibility,
    end: &TokenStream,
) -> Added {
    let Compiled {
        program, sensitive, ..
    } = compiled;
    let mut methods = methods(places, model, program, visibility, end);
    if let Some(sensitive) = sensitive {
        methods.extend(sensitivity::methods(places, model, sensitive, visibility));
    }
    Added {
        methods,
        steps: sensitive
            .as_ref()
            .map_or_else(TokenStream::new, |program| step(krate, program)),
        ..Added::default()
    }
}

/// The methods that tell and set params; nothing without any.
fn methods(
    places: &Places,
    model: &Model,
    program: &Program,
    visibility: &syn::Visibility,
    standstill: &TokenStream,
) -> TokenStream {
    if program.params.is_empty() {
        return TokenStream::new();
    }
    let (scalar, step_reduced) = (scalar(program), step_reduced(program));
    let (motors, names) = (program.motors.len(), &program.params);
    let count = Literal::usize_unsuffixed(names.len());
    let index = |param: usize| Literal::usize_unsuffixed(motors + param);
    let set = ending_with(
        quote!(generated::advance(&mut self.position, target, &known::MOVE_LIMITS, #step_reduced, positions::step).map_err(generated::blocked_params)),
        standstill,
    );
    let given = (0..names.len()).map(|param| {
        let (place, param) = (index(param), Literal::usize_unsuffixed(param));
        quote!(target.values[#place] = params[#param];)
    });
    let mut tokens = quote! {
        /// The names of the params, in the order of their declaration.
        #visibility const PARAMS: [&'static str; #count] = [#(#names),*];

        /// The present values of the params, in the order of their declaration.
        #[must_use]
        #visibility fn params(&self) -> [#scalar; #count] {
            generated::params_of(self.position.motors.values)
        }

        /// Gives the params these values, in the order of their declaration, and assembles everything anew by a continuous change
        /// from where it is; the motors stay where they are.
        ///
        /// # Errors
        /// If a value is not finite, or a loop cannot be closed on the way there: then with the params up to which it could have
        /// gone. The mechanism then stays as it was.
        #visibility fn set_params(&mut self, params: [#scalar; #count]) -> Result<(), Blocked<[#scalar; #count]>> {
            let mut target = self.position.motors;
            #(#given)*
            #set
        }
    };
    for (number, param) in model.params.all().iter().enumerate() {
        let index = index(number);
        let get = user_ident(&param.name, places, param.origin);
        let set = user_ident(&format!("set_{}", param.name), places, param.origin);
        let told = format!(" The present value of param `{}`.", param.name);
        let sets = format!(
            " Gives param `{}` this value and assembles everything anew by a continuous change from where it is; the motors stay \
             where they are.",
            param.name
        );
        let moved = ending_with(
            quote! {
                generated::advance(&mut self.position, target, &known::MOVE_LIMITS, #step_reduced, positions::step)
                    .map_err(|blocked| blocked.starting_at(#index).map(|reached| reached[#index]))
            },
            standstill,
        );
        tokens.extend(quote! {
            #[doc = #told]
            #[must_use]
            #visibility const fn #get(&self) -> #scalar {
                self.position.motors.values[#index]
            }

            #[doc = #sets]
            ///
            /// # Errors
            /// If the value is not finite, or a loop cannot be closed on the way there: then with the value up to which it could
            /// have gone. The mechanism then stays as it was.
            #visibility fn #set(&mut self, value: #scalar) -> Result<(), Blocked<#scalar>> {
                let mut target = self.position.motors;
                target.values[#index] = value;
                #moved
            }
        });
    }
    tokens
}

/// Where an axis is in its link, as an array: an expression inside a method.
pub(super) fn place(model: &Model, program: &Program, id: AxisId) -> TokenStream {
    let axis = model.axis(id);
    let [x, y] = [0, 1].map(|part| match program.place_state(id, part) {
        None => number(program.precision, axis.at[part]),
        Some(state) => {
            let state = Literal::usize_unsuffixed(state);
            quote!(self.position.state[#state])
        }
    });
    quote!([#x, #y])
}
