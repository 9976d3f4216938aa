//! The methods that read and move the motors.

use super::advance::{Target, advance, strip_params, with_end};
use super::emitter::Emitter;
use super::parts::Parts;
use quote::quote;

/// `motors`, `move_to` and `move_toward`.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter {
        visibility,
        values,
        blocked,
        ..
    } = emitter;
    let position = quote!(self.position);
    let Target { before, value } = Target::new(emitter, &position);
    let move_to = strip_params(emitter, advance(emitter, &position, &value));
    let move_to = with_end(emitter, move_to);
    let mut current = quote!(Motors::total(&self.position.motors));
    let mut move_toward = quote!(generated::approach(&mut self.position, #value, &known::MOVE_LIMITS, positions::step));
    if emitter.has_params() {
        current = quote!(generated::motors_of(#current));
        move_toward.extend(quote!(.map(generated::reached_by_motors)));
    }
    let move_toward = with_end(emitter, strip_params(emitter, move_toward));
    let methods = quote! {
                /// The present values of the motors, in the order of their declaration, in radians or scene units.
                #[must_use]
                #visibility fn motors(&self) -> #values {
                    #current
                }

                /// Gives the motors these values, in the order of their declaration, in radians or scene units, and moves
                /// everything accordingly.
                ///
                /// # Errors
                /// If a value is not finite or a loop cannot be closed on the way there; the mechanism then stays where it was.
                #[inline]
                #visibility fn move_to(&mut self, motors: #values) -> Result<(), #blocked> {
                    #before
                    #move_to
                }

                /// Moves towards these values of the motors, in radians or scene units, on the straight way from the present
                /// ones, as far as it can.
                ///
                /// # Errors
                /// If a value is not finite; the mechanism then stays where it was.
                #visibility fn move_toward(&mut self, motors: #values) -> Result<Reached<#values>, #blocked> {
                    #before
                    #move_toward
                }
    };
    Parts::methods(methods)
}
