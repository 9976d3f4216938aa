//! The methods that read and move the motors: by values, by phases if a motor turns, and, where it is proved that a mechanism moves through the
//! ranges of its motors, within these.

use super::Parts;
use super::advance::{Target, advance, end, refusal, step_reduced, strip_params, with_end};
use super::emitter::Emitter;
use super::step::takes_sines;
use super::tokens::integer;
use crate::program;
use proc_macro2::TokenStream;
use quote::quote;

/// `motors`, `move_to` and `move_toward`.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter { visibility, values, blocked, .. } = emitter;
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

/// `turn_to`: phases for the motors that turn, values for those that slide.
pub(super) fn phases(emitter: &Emitter<'_>) -> Parts {
    let Emitter { visibility, scalar, blocked, model, program, .. } = emitter;
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

/// `range` and `move_within`; nothing if a move may fail.
pub(super) fn ranges(emitter: &Emitter<'_>) -> Parts {
    let Emitter { visibility, values, program, .. } = emitter;
    if !program.never_fails() {
        return Parts::default();
    }
    let (step_reduced, end) = (step_reduced(program), end(emitter));
    let there = if takes_sines(program) {
        quote! {
            // Larger angles are reduced first.
            let there = if Motors::is_within(&target, known::MOVE_LIMITS.reduced_range) {
                #step_reduced(&self.position, target)
            } else {
                positions::step(&self.position, target)
            };
        }
    } else {
        quote!(let there = #step_reduced(&self.position, target);)
    };
    let (mut is_finite, mut unranged) = (quote!(Motors::is_finite(&values)), "");
    if program.overflows {
        let most = emitter.number(program::MODERATE);
        is_finite = quote!(Motors::is_within(&values, #most));
        unranged = " A motor without a range may go as far as 1e15.";
    }
    let doc = format!(
        " These values of the motors, in radians or scene units, if all of them are within the declared ranges.{unranged}"
    );
    let methods = quote! {
        #[doc = #doc]
        #[must_use]
        #visibility fn range(motors: #values) -> Option<InRange<Self, #values>> {
            let values = Motors::new(motors);
            (#is_finite && MoveLimits::contains(&known::MOVE_LIMITS, &values)).then_some(InRange::tested(motors))
        }

        /// Moves to values of the motors within their declared ranges. It was proved at compile time that nothing is in the
        /// way there, so this cannot fail.
        #[inline]
        #visibility fn move_within(&mut self, motors: InRange<Self, #values>) {
            let target = Motors::new(motors.motors());
            #there
            // It was proved that every loop closes there: there is nothing else.
            if let Result::Ok(there) = there {
                self.position = there;
            }
            #end
        }
    };
    Parts::methods(methods)
}
