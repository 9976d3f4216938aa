//! The methods that move a mechanism by forces.

use super::actions::bind_loads;
use crate::emit::Parts;
use crate::emit::advance::{advance_with, forces_here, rates_at, record, refusal, strip_params};
use crate::emit::emitter::Emitter;
use crate::emit::rates::stored_rates;
use proc_macro2::TokenStream;
use quote::quote;

/// The field of the motors' rates, the methods that read and set them, `motor_accelerations`, `energy` and `simulate`.
pub(super) fn dynamics(emitter: &Emitter<'_>) -> Parts {
    let Emitter { visibility, scalar, values, motors, blocked, model, .. } = emitter;
    let Some(inertia) = &emitter.compiled.forced.inertia else {
        return Parts::default();
    };
    let advance = advance_with(inertia, &quote!(position), &quote!(motors));
    let found = forces_here(inertia);
    let turning =
        model.motor_ids().map(|motor| emitter.turns(motor) && model.motor(motor).range.is_none());
    let size = model.size();
    let scales = model
        .motor_ids()
        .map(|motor| emitter.number(if emitter.turns(motor) { 1.0 } else { size }));
    let (loads, rates) = (bind_loads(emitter), rates_after(emitter));
    let record = record(emitter);
    let (refusal, inputs) = (refusal(emitter), quote!(known::MOVE_LIMITS.inputs));
    let simulated = quote! {
        generated::simulate(&self.position, &moment, method, |position, motors, rates| {
            #advance
        })
    };
    let simulated = strip_params(emitter, simulated);
    let methods = quote! {
        /// The rates of the motors: how fast they move, in radians or scene units a unit of time.
        #[must_use]
        #visibility const fn rates(&self) -> #values {
            self.rates
        }

        /// Sets how fast the motors move.
        ///
        /// # Errors
        /// If a rate is not finite; all of them then stay what they were.
        #visibility fn set_rates(&mut self, rates: #values) -> Result<(), #blocked> {
            match generated::finite(rates, #inputs) {
                Result::Ok(()) => {
                    self.rates = rates;
                    Result::Ok(())
                }
                Result::Err(stop) => Result::Err(#refusal),
            }
        }

        /// The second rates of the motors under these torques (forces for those that slide), gravity, springs, dampers and
        /// loads.
        ///
        /// # Errors
        /// If a torque is not finite, no mass resists a motor, or the mechanism is at a dead point.
        #visibility fn motor_accelerations(&self, torques: #values) -> Result<#values, #blocked> {
            #loads
            let rates = self.rates;
            generated::finite(torques, #inputs)
                .and_then(|()| #found)
                .and_then(|inertia| Inertia::accelerations(&inertia, torques, #inputs))
                .map_err(|stop| #refusal)
        }

        /// The kinetic energy, and the potential energy of gravity and springs.
        ///
        /// # Errors
        /// If the mechanism is at a dead point, or at a change point where velocities have no limit.
        #visibility fn energy(&self) -> Result<[#scalar; 2], #blocked> {
            #loads
            let rates = self.rates;
            #found
                .map(|inertia| [inertia.kinetic, inertia.potential])
                .map_err(|stop| #refusal)
        }

        /// Lets it move for a step of time under these torques of the motors (forces for those that slide): a step of
        /// [`GaussLegendre::default`].
        ///
        /// # Errors
        /// As for `simulate_by`.
        #visibility fn simulate(&mut self, time: #scalar, torques: #values) -> Result<(), #blocked> {
            Self::simulate_by(self, GaussLegendre::Order4, time, torques)
        }

        /// The same by a method of one's choice: what is more exact takes longer.
        ///
        /// # Errors
        /// If something given is not finite, a loop cannot be closed on the way, or the mechanism is at a dead point. Also if no
        /// mass resists a motor, or the step is too long to be followed. Everything then stays as it was.
        #visibility fn simulate_by(&mut self, method: GaussLegendre, time: #scalar, torques: #values) -> Result<(), #blocked> {
            #loads
            let moment = Moment {
                rates: self.rates,
                torques,
                time,
                inputs: #inputs,
                turning: &[#(#turning),*],
                scales: &[#(#scales),*],
            };
            let simulated = #simulated?;
            #rates
            self.position = simulated.position;
            self.rates = simulated.rates;
            #record
            Result::Ok(())
        }
    };
    let path = emitter.scalar_path();
    Parts {
        fields: quote!(rates: [#path; #motors],),
        start: quote!(rates: [0.0; #motors],),
        methods,
        ..Parts::default()
    }
}

/// The statement that stores velocities and accelerations after a step of time, if they are asked for.
fn rates_after(emitter: &Emitter<'_>) -> Option<TokenStream> {
    let moving = emitter.compiled.moving.as_ref()?;
    let refusal = refusal(emitter);
    let [pattern, store] = stored_rates(emitter);
    let mut arguments = quote!(, simulated.rates);
    if emitter.model.effects.acceleration {
        arguments.extend(quote!(, simulated.accelerations));
    }
    let rates = rates_at(moving, &quote!(simulated.position), &arguments);
    Some(quote! {
        match #rates {
            Result::Ok(#pattern) => {
                #store
            }
            Result::Err(stop) => return Result::Err(#refusal),
        }
    })
}
