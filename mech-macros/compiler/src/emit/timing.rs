//! The method that moves motors by their laws.

use super::Parts;
use super::advance::{advance, refusal, strip_params, with_end};
use super::emitter::Emitter;
use super::rates::advance_at_rates;
use super::step::laws;
use super::tokens::integer;
use crate::bug::bug;
use proc_macro2::TokenStream;
use quote::quote;

/// `at_time`; nothing without laws.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Some(timing) = &emitter.compiled.timing else {
        return Parts::default();
    };
    Parts { methods: at_time(emitter), modules: laws(emitter, timing), ..Parts::default() }
}

fn at_time(emitter: &Emitter<'_>) -> TokenStream {
    let Emitter { visibility, blocked, model, .. } = emitter;
    let laws = model.lawful_motors().map(|(motor, law)| {
        let joint = &model.joint(model.motor(motor).joint).name;
        format!("`{joint} = {}`", law.written)
    });
    let laws: Vec<String> = laws.collect();
    let doc = format!(
        " Moves the motors that follow laws to where these have them at a time, and everything accordingly: {}.",
        laws.join(", ")
    );
    let others = (laws.len() < model.motors.len())
        .then(|| quote!(#[doc = " The other motors stay where they are."]));
    let Some((first, _)) = model.lawful_motors().next() else {
        bug!("there is a timing without a law");
    };
    let first = integer(first.index());
    let effects = model.effects;
    let found = match (effects.velocity, effects.acceleration) {
        (false, _) => quote!(motors),
        (true, false) => quote!((motors, rates)),
        (true, true) => quote!((motors, rates, accelerations)),
    };
    let motors = quote!(motors);
    let advance = if let Some(moving) = &emitter.compiled.moving {
        advance_at_rates(emitter, moving, &motors)
    } else {
        let advance = advance(emitter, &quote!(self.position), &motors);
        with_end(emitter, strip_params(emitter, advance))
    };
    let refusal = refusal(emitter);
    let errors = if effects.velocity {
        quote! {
            #[doc = " If the time, or a law's value or rate at it, is not finite, or a loop cannot be closed on the way there."]
            #[doc = " Also if it is at a dead point or a change point there, where rates are not determined. The mechanism"]
            #[doc = " then stays where it was."]
        }
    } else {
        quote! {
            #[doc = " If the time, or the value of a law at it, is not finite, or a loop cannot be closed on the way there."]
            #[doc = " The mechanism then stays where it was."]
        }
    };
    quote! {
        #[doc = #doc]
        #others
        ///
        /// # Errors
        #errors
        #visibility fn at_time(&mut self, t: f64) -> Result<(), #blocked> {
            let there = generated::finite([t], &[known::MOVE_LIMITS.inputs[#first]])
                .and_then(|()| laws::laws(self.position.motors, t));
            let #found = match there {
                Result::Ok(there) => there,
                Result::Err(stop) => return Result::Err(#refusal),
            };
            #advance
        }
    }
}
