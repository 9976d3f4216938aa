//! The method that takes phases, if a motor turns.

use super::advance::{advance, refusal, strip_params, with_end};
use super::emitter::Emitter;
use super::parts::Parts;
use super::tokens::integer;
use proc_macro2::TokenStream;
use quote::quote;

/// `turn_to`: phases for the motors that turn, values for those that slide.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter {
        visibility,
        scalar,
        blocked,
        model,
        program,
        ..
    } = emitter;
    let (mut values, mut phases) = (Vec::new(), TokenStream::new());
    let (mut turning, mut sliding) = (0, 0);
    let refusal = refusal(emitter);
    for (motor, name) in model.motor_ids().zip(&program.motors) {
        if emitter.turns(motor) {
            let (index, phase) = (integer(motor.index()), integer(turning));
            phases.extend(quote! {
                if let Result::Err(stop) = Motors::turn(&mut target, #index, phases[#phase], #name) {
                    return Result::Err(#refusal);
                }
            });
            values.push(quote!(0.0));
            turning += 1;
        } else {
            let slide = integer(sliding);
            values.push(quote!(slides[#slide]));
            sliding += 1;
        }
    }
    if turning == 0 {
        return Parts::default();
    }
    let advance = advance(emitter, &quote!(self.position), &quote!(target));
    let advance = with_end(emitter, strip_params(emitter, advance));
    let start = if emitter.has_params() {
        quote!(generated::inputs([#(#values),*], &self.position.motors))
    } else {
        quote!(Motors::new([#(#values),*]))
    };
    let (mut slides, mut doc) = (
        TokenStream::new(),
        " The same with a phase for each motor: exact after any number of turns.",
    );
    if sliding > 0 {
        let sliding = integer(sliding);
        slides = quote!(, slides: [#scalar; #sliding]);
        doc = " The same with phases for the motors that turn, and values for those that slide: exact after any number of turns. Both are \
             in the order of their declaration.";
    }
    let turning = integer(turning);
    let methods = quote! {
        #[doc = #doc]
        ///
        /// # Errors
        /// If a value is not finite, a phase is beyond 2³¹ turns, or a loop cannot be closed on the way there. The mechanism
        /// then stays where it was.
        #visibility fn turn_to(&mut self, phases: [Phase; #turning] #slides) -> Result<(), #blocked> {
            let mut target = #start;
            #phases
            #advance
        }
    };
    Parts::methods(methods)
}
