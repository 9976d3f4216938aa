//! The methods that tell what it takes to hold a mechanism at rest, and to move it.

use super::Writer;
use crate::emit::items::user_ident;
use crate::emit::motion::{found, given};
use crate::emit::moves::{advance_with, step_full};
use crate::emit::params;
use crate::model::{Load, LoadKind};
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

impl Writer<'_> {
    /// The methods that tell what holds it at rest.
    pub(super) fn holding(&self, holding: &Program) -> TokenStream {
        let Self {
            scalar,
            motors,
            visibility,
            standstill,
            ..
        } = self;
        let [_, arguments] = given(holding);
        let step_full = step_full(holding);
        let (loads, blocked) = (self.given_loads(), self.blocked());
        let [target, present] = params::target(self.program, &quote!(self.position));
        let refused = params::refused(self.program);
        let moved = params::of_motors(
            self.program,
            advance_with(holding, &quote!(&mut self.position), &target, &arguments),
        );
        quote! {
            /// Moves there as `move_to` does, and gives the torques of the motors (the forces of those that slide) that hold it
            /// there at rest, in the order of their declaration: against gravity, springs and loads.
            ///
            /// # Errors
            /// If a value is not finite, a loop cannot be closed on the way there, or it is at a dead point or a change point
            /// there, where torques are not determined; the mechanism then stays where it was.
            #[inline]
            #visibility fn hold_at(&mut self, motors: [#scalar; #motors]) -> Result<[#scalar; #motors], #blocked> {
                #loads
                #present
                let held = #moved?;
                #standstill
                Result::Ok(held.torques)
            }

            /// The torques of the motors (the forces of those that slide) that hold it at rest where it is.
            ///
            /// # Errors
            /// If the mechanism is at a dead point or a change point, where these are not determined.
            #visibility fn torques(&self) -> Result<[#scalar; #motors], #blocked> {
                #loads
                generated::rates_at(&self.position, |last, motors| #step_full(last, motors #arguments))
                    .map(|held| held.torques)
                    .map_err(|stop| #refused)
            }
        }
    }

    /// The methods that tell what it takes to move.
    pub(super) fn inverse_dynamics(&self, inverse_dynamics: &Program) -> TokenStream {
        let Self {
            scalar,
            motors,
            visibility,
            model,
            ..
        } = self;
        let [_, arguments] = given(inverse_dynamics);
        let (step_full, loads, blocked) = (
            step_full(inverse_dynamics),
            self.given_loads(),
            self.blocked(),
        );
        let (found, _) = found(inverse_dynamics);
        let refused = params::refused(self.program);
        let mut tokens = quote! {
            /// What it takes to move at these rates and second rates of the motors from where it is: the torques of the motors,
            /// the reaction in each joint, the transmission angles.
            ///
            /// # Errors
            /// If a rate is not finite, or the mechanism is at a dead point or a change point, where forces are not determined.
            #visibility fn forces(&self, rates: [#scalar; #motors], accelerations: [#scalar; #motors]) -> Result<#found, #blocked> {
                #loads
                generated::finite(rates, known::MOVE_LIMITS.inputs)
                    .and_then(|()| generated::finite(accelerations, known::MOVE_LIMITS.inputs))
                    .and_then(|()| generated::rates_at(&self.position, |last, motors| #step_full(last, motors #arguments)))
                    .map_err(|stop| #refused)
            }
        };
        for (first, load) in model.actions.numbered_loads() {
            tokens.extend(self.advantage(first, load));
        }
        tokens
    }

    /// The method that tells the mechanical advantage over a load.
    fn advantage(&self, first: usize, load: &Load) -> TokenStream {
        let Self {
            scalar,
            motors,
            visibility,
            ..
        } = self;
        let name = user_ident(
            &format!("{}_advantage", load.name),
            self.places,
            load.origin,
        );
        let blocked = self.blocked();
        let index = Literal::usize_unsuffixed(first);
        let (direction, test, follows) = match load.kind {
            LoadKind::Torque(_) => (quote!(), quote!(), quote!(velocity_ratio[#index])),
            LoadKind::Force(_) => {
                let (next, place) = (Literal::usize_unsuffixed(first + 1), &load.name);
                let refused =
                    params::refused_by(self.program, &quote!(generated::not_finite(#place)));
                (
                    quote!(, along: [#scalar; 2]),
                    quote! {
                        let [x, y] = along;
                        let length = generated::sqrt(x * x + y * y);
                        let is_direction = length > 0.0 && Real::is_finite(length);
                        if !is_direction {
                            return Result::Err(#refused);
                        }
                    },
                    quote!((velocity_ratio[#index] * x + velocity_ratio[#next] * y) / length),
                )
            }
        };
        let what = match load.kind {
            LoadKind::Torque(_) => "",
            LoadKind::Force(_) => ", for forces in this direction",
        };
        let doc = format!(
            " The mechanical advantage of each motor over load `{}`{what}: how much of it a torque of one (a force, where it slides)",
            load.name
        );
        quote! {
            #[doc = #doc]
            /// balances, if there is nothing else. It is infinite where the load stands still while the motor moves.
            ///
            /// # Errors
            /// If the mechanism is at a dead point or a change point, where this is not determined, or a direction is zero.
            #visibility fn #name(&self #direction) -> Result<[#scalar; #motors], #blocked> {
                #test
                let forces = Self::forces(self, [0.0; #motors], [0.0; #motors])?;
                Result::Ok(forces.velocity_ratios.map(|velocity_ratio| -1.0 / (#follows)))
            }
        }
    }
}
