//! The methods that move a mechanism by forces.

use super::Writer;
use crate::emit::motion::given;
use crate::emit::moves::{advance_with, step_full};
use crate::emit::params;
use crate::emit::scope::number;
use crate::model::{JointKind, Motor};
use crate::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

impl Writer<'_> {
    /// The methods that move it by forces.
    pub(super) fn dynamics(&self, inertia: &Program) -> TokenStream {
        let Self {
            scalar,
            motors,
            visibility,
            ..
        } = self;
        let [_, arguments] = given(inertia);
        let step_full = step_full(inertia);
        let moved = advance_with(inertia, &quote!(position), &quote!(motors), &arguments);
        let (loads, blocked) = (self.given_loads(), self.blocked());
        let turns =
            |motor: &Motor| matches!(self.model.joint(motor.joint).kind, JointKind::Revolute(..));
        let motors_of_model = self.model.motors.iter();
        let turning = motors_of_model
            .clone()
            .map(|motor| turns(motor) && motor.range.is_none());
        let size = self.model.size();
        let scales = motors_of_model
            .map(|motor| number(self.model.precision, if turns(motor) { 1.0 } else { size }));
        let (velocities, record) = (self.velocities(), self.record);
        let (refused, inputs) = (
            params::refused(self.program),
            quote!(known::MOVE_LIMITS.inputs),
        );
        let simulated = params::of_motors(
            self.program,
            quote! {
                generated::simulate(&self.position, &moment, method, |position, motors, rates| {
                    #moved
                })
            },
        );
        quote! {
            /// The rates of the motors: how fast they move, in radians or scene units a unit of time.
            #[must_use]
            #visibility const fn rates(&self) -> [#scalar; #motors] {
                self.rates
            }

            /// Sets how fast the motors move.
            ///
            /// # Errors
            /// If a rate is not finite; all of them then stay what they were.
            #visibility fn set_rates(&mut self, rates: [#scalar; #motors]) -> Result<(), #blocked> {
                match generated::finite(rates, #inputs) {
                    Result::Ok(()) => {
                        self.rates = rates;
                        Result::Ok(())
                    }
                    Result::Err(stop) => Result::Err(#refused),
                }
            }

            /// The second rates of the motors under these torques (forces for those that slide), gravity, springs, dampers and
            /// loads.
            ///
            /// # Errors
            /// If a torque is not finite, no mass resists a motor, or the mechanism is at a dead point or a change point.
            #visibility fn motor_accelerations(&self, torques: [#scalar; #motors]) -> Result<[#scalar; #motors], #blocked> {
                #loads
                let rates = self.rates;
                generated::finite(torques, #inputs)
                    .and_then(|()| generated::rates_at(&self.position, |last, motors| #step_full(last, motors #arguments)))
                    .and_then(|inertia| Inertia::accelerations(&inertia, torques, #inputs))
                    .map_err(|stop| #refused)
            }

            /// The kinetic energy, and the potential energy of gravity and springs.
            ///
            /// # Errors
            /// If the mechanism is at a dead point or a change point, where velocities are not determined.
            #visibility fn energy(&self) -> Result<[#scalar; 2], #blocked> {
                #loads
                let rates = self.rates;
                generated::rates_at(&self.position, |last, motors| #step_full(last, motors #arguments))
                    .map(|inertia| [inertia.kinetic, inertia.potential])
                    .map_err(|stop| #refused)
            }

            /// Lets it move for a step of time under these torques of the motors (forces for those that slide): a step of
            /// [`GaussLegendre::default`].
            ///
            /// # Errors
            /// As for `simulate_by`.
            #visibility fn simulate(&mut self, time: #scalar, torques: [#scalar; #motors]) -> Result<(), #blocked> {
                Self::simulate_by(self, GaussLegendre::Order4, time, torques)
            }

            /// The same by a method of one's choice: what is more exact takes longer.
            ///
            /// # Errors
            /// If something given is not finite, a loop cannot be closed on the way, the mechanism is at a dead point or a change
            /// point, no mass resists a motor, or the step is too long to be followed; everything then stays as it was.
            #visibility fn simulate_by(&mut self, method: GaussLegendre, time: #scalar, torques: [#scalar; #motors]) -> Result<(), #blocked> {
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
                #velocities
                self.position = simulated.position;
                self.rates = simulated.rates;
                #record
                Result::Ok(())
            }
        }
    }

    /// What velocities are after a step of time, if they were asked for.
    fn velocities(&self) -> TokenStream {
        let effects = self.model.effects;
        if !effects.velocity {
            return TokenStream::new();
        }
        let refused = params::refused(self.program);
        let (given, found, keep) = if effects.acceleration {
            (
                quote!(, simulated.rates, simulated.accelerations),
                quote!((velocities, accelerations)),
                quote!(self.accelerations = accelerations;),
            )
        } else {
            (
                quote!(, simulated.rates),
                quote!(velocities),
                TokenStream::new(),
            )
        };
        quote! {
            match generated::rates_at(&simulated.position, |last, motors| rates::step(last, motors #given)) {
                Result::Ok(#found) => {
                    self.velocities = velocities;
                    #keep
                }
                Result::Err(stop) => return Result::Err(#refused),
            }
        }
    }
}
