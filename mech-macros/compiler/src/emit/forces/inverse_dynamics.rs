//! The methods that return the torques and reactions by which a mechanism stands or moves.

use super::actions::bind_loads;
use crate::emit::Parts;
use crate::emit::advance::{
    Target, advance_with, end, forces_here, refusal, refusal_by, strip_params,
};
use crate::emit::emitter::Emitter;
use crate::emit::step::outcome_type;
use crate::emit::tokens::integer;
use crate::model::{Load, LoadKind};
use proc_macro2::TokenStream;
use quote::quote;

/// `hold_at`, `torques` and `come_to_rest`.
pub(super) fn holding(emitter: &Emitter<'_>) -> Parts {
    let Emitter { visibility, values, motors, blocked, model, .. } = emitter;
    let Some(holding) = &emitter.compiled.forced.holding else {
        return Parts::default();
    };
    let (loads, end) = (bind_loads(emitter), end(emitter));
    let position = quote!(self.position);
    let Target { before, value } = Target::new(emitter, &position);
    let refusal = refusal(emitter);
    let advance = advance_with(holding, &quote!(&mut #position), &value);
    let advance = strip_params(emitter, advance);
    let found = forces_here(holding);
    let units = model.motor_ids();
    let units = units.map(|motor| emitter.number(model.unit_of(motor)));
    let fall = advance_with(holding, &quote!(position), &quote!(motors));
    let fall = strip_params(
        emitter,
        quote! {
            generated::come_to_rest(&mut #position, &known::MOVE_LIMITS, free, [#(#units),*], |position, motors| {
                #fall
            })
        },
    );
    let methods = quote! {
        /// Moves there as `move_to` does, and gives the torques of the motors (the forces of those that slide), in the order of
        /// their declaration. They hold it there at rest, against gravity, springs and loads.
        ///
        /// # Errors
        /// If a value is not finite, a loop cannot be closed on the way, or torques are not determined there, as at a dead point.
        /// The mechanism then stays where it was.
        #[inline]
        #visibility fn hold_at(&mut self, motors: #values) -> Result<#values, #blocked> {
            #loads
            #before
            let held = #advance?;
            #end
            Result::Ok(held.torques)
        }

        /// The torques of the motors (the forces of those that slide) that hold it at rest where it is.
        ///
        /// # Errors
        /// If the mechanism is at a dead point, or at a change point where these have no limit.
        #visibility fn torques(&self) -> Result<#values, #blocked> {
            #loads
            #found
                .map(|held| held.torques)
                .map_err(|stop| #refusal)
        }

        /// Lets go of the motors that are `free`, and goes downhill from where it is until springs, gravity and loads hold it at
        /// rest. Other motors stay where they are.
        ///
        /// Gives the torques of the motors that do not rest by themselves (the forces of those that slide), as `torques` does.
        /// These motors are held, or lean against an end of their range. All others have zero.
        ///
        /// # Errors
        /// If nothing pulls at a motor that is free, or nothing stops what pulls at one. Also if torques are not determined where it
        /// is, or a loop comes to a dead point on the way. The mechanism then stays where it was.
        #visibility fn come_to_rest(&mut self, free: [bool; #motors]) -> Result<#values, #blocked> {
            #loads
            let torques = #fall?;
            #end
            Result::Ok(torques)
        }
    };
    Parts::methods(methods)
}

/// `forces`, and the mechanical advantage over each load.
pub(super) fn forces(emitter: &Emitter<'_>) -> Parts {
    let Emitter { visibility, values, blocked, model, .. } = emitter;
    let Some(inverse_dynamics) = &emitter.compiled.forced.inverse_dynamics else {
        return Parts::default();
    };
    let (loads, kind) = (bind_loads(emitter), outcome_type(inverse_dynamics));
    let (found, refusal) = (forces_here(inverse_dynamics), refusal(emitter));
    let mut methods = quote! {
        /// The torques of the motors, the reaction in each joint and the transmission angles, where it is, if the motors move at these
        /// rates and second rates.
        ///
        /// # Errors
        /// If a rate is not finite, or the mechanism is at a dead point, or at a change point where forces have no limit.
        #visibility fn forces(&self, rates: #values, accelerations: #values) -> Result<#kind, #blocked> {
            #loads
            generated::finite(rates, known::MOVE_LIMITS.inputs)
                .and_then(|()| generated::finite(accelerations, known::MOVE_LIMITS.inputs))
                .and_then(|()| #found)
                .map_err(|stop| #refusal)
        }
    };
    let loads = model.actions.numbered_loads();
    methods.extend(loads.map(|(first, load)| advantage(emitter, first, load)));
    Parts::methods(methods)
}

/// The method that returns the mechanical advantage over a load; `first` is the index of the load's first number.
fn advantage(emitter: &Emitter<'_>, first: usize, load: &Load) -> TokenStream {
    let Emitter { visibility, scalar, values, motors, blocked, .. } = emitter;
    let name = emitter.ident(&format!("{}_advantage", load.name), load.origin);
    let index = integer(first);
    let (mut parameter, mut test, mut what) = (None, None, "");
    let mut ratio = quote!(velocity_ratio[#index]);
    if let LoadKind::Force(_) = load.kind {
        let (next, place) = (integer(first + 1), &load.name);
        let refusal = refusal_by(emitter, &quote!(generated::not_finite(#place)));
        what = ", for forces in this direction";
        parameter = Some(quote!(, along: [#scalar; 2]));
        test = Some(quote! {
            let [x, y] = along;
            let length = generated::sqrt(x * x + y * y);
            let is_direction = length > 0.0 && Real::is_finite(length);
            if !is_direction {
                return Result::Err(#refusal);
            }
        });
        ratio = quote!((#ratio * x + velocity_ratio[#next] * y) / length);
    }
    let doc = format!(
        " The mechanical advantage of each motor over load `{}`{what}: how much of it a torque of one (a force, where it slides)",
        load.name
    );
    quote! {
        #[doc = #doc]
        /// balances, if there is nothing else. It is infinite where the load stands still while the motor moves.
        ///
        /// # Errors
        /// If the mechanism is at a dead point, or at a change point where this has no limit, or a direction is zero.
        #visibility fn #name(&self #parameter) -> Result<#values, #blocked> {
            #test
            let forces = Self::forces(self, [0.0; #motors], [0.0; #motors])?;
            Result::Ok(forces.velocity_ratios.map(|velocity_ratio| -1.0 / (#ratio)))
        }
    }
}
