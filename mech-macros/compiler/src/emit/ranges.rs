//! The methods of a mechanism that is proved to move through the ranges of its motors.

use super::advance::{end, step_reduced};
use super::emitter::Emitter;
use super::parts::Parts;
use super::step::takes_sines;
use crate::program;
use quote::quote;

/// `range` and `move_within`; nothing if a move may fail.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter {
        visibility,
        values,
        program,
        ..
    } = emitter;
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
