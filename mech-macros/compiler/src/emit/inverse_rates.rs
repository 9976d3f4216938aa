//! The method that leads a point at a velocity.

use super::Parts;
use super::advance::{rates_at, record};
use super::emitter::Emitter;
use super::least;
use super::led::{Rates, count, here, lead};
use super::rates::stored_rates;
use crate::model::Inverse;
use crate::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

/// `reach_with`; nothing without rates, and where motors follow no point.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    match (&emitter.model.inverse, &emitter.compiled.moving) {
        (Some(inverse), Some(moving)) => Parts::methods(reach_with(emitter, inverse, moving)),
        _ => Parts::default(),
    }
}

fn reach_with(emitter: &Emitter<'_>, inverse: &Inverse, moving: &Program) -> TokenStream {
    let Emitter { visibility, scalar, model, .. } = emitter;
    let (count, here) = (count(inverse), here(emitter, inverse));
    let ([pattern, store], record) = (stored_rates(emitter), record(emitter));
    let store_rates = model.effects.dynamics.then(|| quote!(self.rates = rates;));
    let (rated, given, acceleration) = if model.effects.acceleration {
        (
            "this velocity and acceleration",
            quote!([velocity, acceleration]),
            Some(quote!(, acceleration: [#scalar; #count])),
        )
    } else {
        ("this velocity", quote!([velocity]), None)
    };
    let name = inverse.name(model);
    let doc = format!(
        " Leads `{name}` to this place as `reach` does, and gives it {rated}: rates of motors follow."
    );
    let following = following(emitter, inverse, moving);
    let (lead, held) = if inverse.is_least {
        let lead = least::lead(emitter, inverse, moving);
        (lead, quote!(self.position))
    } else {
        (lead(), quote!((self.position, self.inverse)))
    };
    quote! {
        #[doc = #doc]
        /// Motors that do not follow rest.
        ///
        /// # Errors
        /// As `reach`, and if rates are not determined there; the mechanism then stays where it was.
        #visibility fn reach_with(
            &mut self,
            place: [#scalar; #count],
            velocity: [#scalar; #count]
            #acceleration
        ) -> Result<(), Blocked<[#scalar; #count]>> {
            let here = #here;
            let refuse = |stop: generated::Stop| Blocked::of(Blocked::new(stop.place, stop.cause, here), &inverse::GIVEN);
            for given in #given {
                generated::finite(given, &inverse::GIVEN).map_err(refuse)?;
            }
            let before = #held;
            #lead?;
            let found = (|| {
                #following
            })();
            match found {
                Result::Ok((rates, #pattern)) => {
                    #store
                    #store_rates
                    #record
                    Result::Ok(())
                }
                Result::Err(stop) => {
                    #held = before;
                    Result::Err(refuse(stop))
                }
            }
        }
    }
}

/// The statements that find the rates of motors, and everything that moves at them, from the variables `velocity` and `acceleration`.
fn following(emitter: &Emitter<'_>, inverse: &Inverse, moving: &Program) -> TokenStream {
    let Emitter { scalar, motors, .. } = emitter;
    let name = inverse.name(emitter.model);
    let found = |arguments: TokenStream| rates_at(moving, &quote!(self.position), &arguments);
    let Rates { velocity, acceleration } = Rates::new(emitter, inverse);
    let solve = |given: TokenStream| {
        if inverse.is_least {
            quote!(generated::least_rates(&inverse::LED, #given, influence, led)?)
        } else {
            quote!(generated::led_rates(inverse::MOTORS, #given, #name, influence, led)?)
        }
    };
    let rates = |found: TokenStream| {
        let solved = solve(quote!(velocity));
        quote! {
            let influence = |rates: [#scalar; #motors]| #found;
            let led = |velocities: &[Velocity<#scalar>; _]| #velocity;
            let rates = #solved;
        }
    };
    if !emitter.model.effects.acceleration {
        let found = found(quote!(, rates));
        let rates = rates(found);
        return quote! {
            #rates
            let found = influence(rates)?;
            Result::Ok((rates, found))
        };
    }
    let (unresisted, all) =
        (found(quote!(, rates, [0.0; #motors])), found(quote!(, rates, accelerations)));
    let rates = rates(quote!(Result::map(#unresisted, |(velocities, _)| velocities)));
    let solved = solve(quote!(wanted));
    quote! {
        #rates
        let (velocities, accelerations) = #unresisted?;
        let wanted = generated::less(acceleration, #acceleration);
        let accelerations = #solved;
        let found = #all?;
        Result::Ok((rates, found))
    }
}
