//! The methods that read and change params.

use super::Parts;
use super::advance::{advance, with_end};
use super::emitter::Emitter;
use super::tokens::{integer, setter};
use quote::quote;

/// `PARAMS`, `params` and `set_params`, and two methods for each param; nothing without params.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter { visibility, scalar, params: count, model, program, .. } = emitter;
    if !emitter.has_params() {
        return Parts::default();
    }
    let names = &program.params;
    let index = |param: usize| integer(program.motors.len() + param);
    let advance = advance(emitter, &quote!(self.position), &quote!(target));
    let set = with_end(emitter, quote!(#advance.map_err(generated::blocked_params)));
    let changes = (0..names.len()).map(|param| {
        let (place, param) = (index(param), integer(param));
        quote!(target.values[#place] = params[#param];)
    });
    let mut methods = quote! {
        /// The names of the params, in the order of their declaration.
        #visibility const PARAMS: [&'static str; #count] = [#(#names),*];

        /// The present values of the params, in the order of their declaration.
        #[must_use]
        #visibility fn params(&self) -> [#scalar; #count] {
            generated::params_of(self.position.motors.values)
        }

        /// Gives the params these values, in the order of their declaration, and assembles everything anew by a continuous change
        /// from where it is. The motors stay where they are.
        ///
        /// # Errors
        /// If a value is not finite, or a loop cannot be closed on the way there. That error has the params up to which it could
        /// have gone. The mechanism then stays as it was.
        #visibility fn set_params(&mut self, params: [#scalar; #count]) -> Result<(), Blocked<[#scalar; #count]>> {
            let mut target = self.position.motors;
            #(#changes)*
            #set
        }
    };
    for (number, param) in model.params.all().iter().enumerate() {
        let (name, index) = (&param.name, index(number));
        let getter = emitter.ident(name, param.origin);
        let setter = emitter.ident(&setter(name), param.origin);
        let doc = format!(" The present value of param `{name}`.");
        let value = quote!(self.position.motors.values[#index]);
        methods.extend(emitter.constant_accessor(&getter, &doc, scalar, &value));
        let doc = format!(
            " Gives param `{name}` this value and assembles everything anew by a continuous change from where it is. The motors stay \
             where they are."
        );
        let set = with_end(
            emitter,
            quote! {
                #advance.map_err(|blocked| blocked.starting_at(#index).map(|reached| reached[#index]))
            },
        );
        methods.extend(quote! {
            #[doc = #doc]
            ///
            /// # Errors
            /// If the value is not finite, or a loop cannot be closed on the way there. That error has the value up to which it
            /// could have gone. The mechanism then stays as it was.
            #visibility fn #setter(&mut self, value: #scalar) -> Result<(), Blocked<#scalar>> {
                let mut target = self.position.motors;
                target.values[#index] = value;
                #set
            }
        });
    }
    Parts::methods(methods)
}
