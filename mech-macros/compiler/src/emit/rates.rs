//! The fields and methods of velocities and accelerations.

use super::Parts;
use super::advance::{Target, advance_with, rates_at, record, refusal, strip_params};
use super::costs::extra_cost;
use super::emitter::Emitter;
use super::rate_accessors::rate_accessors;
use super::step::{parameters, step};
use crate::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

/// The rates of links, points and joints; nothing if they are not asked for.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let Emitter { krate, links, compiled, .. } = emitter;
    let Some(moving) = &compiled.moving else {
        return Parts::default();
    };
    let scalar = emitter.scalar_path();
    let what = "the rates of everything";
    let mut parts = Parts {
        fields: quote!(velocities: [#krate::Velocity<#scalar>; #links],),
        start: quote!(velocities: [Velocity::ZERO; #links],),
        methods: [
            methods(emitter, moving),
            extra_cost(emitter, moving, "RATES_COST", what),
            rate_accessors(emitter),
        ]
        .into_iter()
        .collect(),
        modules: step(krate, moving),
        ..Parts::default()
    };
    if emitter.model.effects.acceleration {
        parts.fields.extend(quote!(accelerations: [#krate::Acceleration<#scalar>; #links],));
        parts.start.extend(quote!(accelerations: [Acceleration::ZERO; #links],));
    }
    parts
}

/// The pattern of what a program of rates computes, and the statements that store it.
pub(super) fn stored_rates(emitter: &Emitter<'_>) -> [TokenStream; 2] {
    let store = quote!(self.velocities = velocities;);
    if emitter.model.effects.acceleration {
        let store = quote!(#store self.accelerations = accelerations;);
        [quote!((velocities, accelerations)), store]
    } else {
        [quote!(velocities), store]
    }
}

/// The statements that move a mechanism to `target` at the rates that are given.
pub(super) fn advance_at_rates(
    emitter: &Emitter<'_>,
    moving: &Program,
    target: &TokenStream,
) -> TokenStream {
    let effects = emitter.model.effects;
    let accelerations = effects.acceleration.then(|| quote!(, accelerations));
    let [pattern, store] = stored_rates(emitter);
    let store_rates = effects.dynamics.then(|| quote!(self.rates = rates;));
    let record = record(emitter);
    let refusal = refusal(emitter);
    let advance = advance_with(moving, &quote!(&mut self.position), target);
    let advance = strip_params(emitter, advance);
    quote! {
        for rates in [rates #accelerations] {
            if let Result::Err(stop) = generated::finite(rates, known::MOVE_LIMITS.inputs) {
                return Result::Err(#refusal);
            }
        }
        let #pattern = #advance?;
        #store
        #store_rates
        #record
        Result::Ok(())
    }
}

/// `move_with`, `velocities`, `accelerations` and `influence_coefficients`.
fn methods(emitter: &Emitter<'_>, moving: &Program) -> TokenStream {
    let Emitter { visibility, scalar, values, links, motors, blocked, .. } = emitter;
    let parameters = parameters(moving);
    let Target { before, value } = Target::new(emitter, &quote!(self.position));
    let advance = advance_at_rates(emitter, moving, &value);
    let refusal = refusal(emitter);
    let (mut given, mut arguments) = ("values and rates", quote!(, rates));
    let (mut accelerations, mut first) = (None, None);
    if emitter.model.effects.acceleration {
        given = "values, rates and second rates";
        arguments = quote!(, rates, [0.0; #motors]);
        first = Some(quote!(.0));
        accelerations = Some(quote! {
            /// The accelerations of the moving links in the scene, in the order of their declaration.
            #[must_use]
            #visibility const fn accelerations(&self) -> &[Acceleration<#scalar>; #links] {
                &self.accelerations
            }
        });
    }
    let found = rates_at(moving, &quote!(self.position), &arguments);
    let doc = format!(
        " Gives the motors these {given}, in the order of their declaration, in radians or scene units and units of time, and moves everything accordingly."
    );
    quote! {
        #[doc = #doc]
        /// After a move without rates it rests.
        ///
        /// # Errors
        /// If a value is not finite, a loop cannot be closed on the way, or rates are not determined there, as at a dead point.
        /// The mechanism then stays where it was.
        #[inline]
        #visibility fn move_with(&mut self, motors: #values #parameters) -> Result<(), #blocked> {
            #before
            #advance
        }

        /// The velocities of the moving links in the scene, in the order of their declaration.
        #[must_use]
        #visibility const fn velocities(&self) -> &[Velocity<#scalar>; #links] {
            &self.velocities
        }

        #accelerations

        /// The influence coefficients: for each motor, the velocities of the moving links if it alone moves, at a rate of one.
        ///
        /// # Errors
        /// If the mechanism is at a dead point, or at a change point where these have no limit.
        #visibility fn influence_coefficients(&self) -> Result<[[Velocity<#scalar>; #links]; #motors], #blocked> {
            let mut influence_coefficients = [[Velocity::ZERO; #links]; #motors];
            for (motor, influence) in Iterator::enumerate(<[_]>::iter_mut(&mut influence_coefficients)) {
                let mut rates = [0.0; #motors];
                rates[motor] = 1.0;
                let found = #found;
                match found {
                    Result::Ok(found) => *influence = found #first,
                    Result::Err(stop) => return Result::Err(#refusal),
                }
            }
            Result::Ok(influence_coefficients)
        }
    }
}
