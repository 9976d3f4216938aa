//! The results of a step besides a position: rates or forces.

use super::scope::Scope;
use crate::bug::bug;
use crate::emit::tokens::{integer, scalar};
use crate::program::{Forces, LinkRates, Program, Results, Value};
use proc_macro2::TokenStream;
use quote::quote;

/// The rates or forces that a step computes: their type, their value, and what documentation calls them.
pub(super) struct Outcome {
    pub(super) kind: TokenStream,
    pub(super) value: TokenStream,
    pub(super) what: &'static str,
}

impl Outcome {
    /// That of the program of a scope, if it computes rates or forces.
    pub(super) fn of(scope: &Scope<'_>) -> Option<Self> {
        let (value, what) = match scope.program.results()? {
            Results::Rates(found) => (rates(found, scope), "the rates of all links"),
            Results::Forces { forces, .. } => {
                let what = match forces {
                    Forces::Holding(_) => "what holds it there",
                    Forces::InverseDynamics(_) => "the forces in it",
                    Forces::Inertia(_) => "its inertia as the motors feel it",
                };
                (self::forces(forces, scope), what)
            }
            Results::Sensitivity(_) => return None,
        };
        Some(Self { kind: outcome_type(scope.program), value, what })
    }
}

/// An array of the links' rates, each a struct of this name.
pub(super) fn rates_of_links(
    name: &TokenStream,
    rates: &[[Value; 3]],
    scope: &Scope<'_>,
) -> TokenStream {
    let rates = rates.iter().map(|rates| {
        let [angular, x, y] = rates.map(|rate| scope.expression(rate));
        quote!(#name { angular: #angular, x: #x, y: #y })
    });
    quote!([#(#rates),*])
}

fn rates(rates: &LinkRates<Value>, scope: &Scope<'_>) -> TokenStream {
    let velocities = rates_of_links(&quote!(Velocity), &rates.velocities, scope);
    match &rates.accelerations {
        None => velocities,
        Some(accelerations) => {
            let accelerations = rates_of_links(&quote!(Acceleration), accelerations, scope);
            quote!((#velocities, #accelerations))
        }
    }
}

fn forces(forces: &Forces<Value>, scope: &Scope<'_>) -> TokenStream {
    let row = |values: &Vec<Value>| {
        let values = scope.expressions(values);
        quote!([#(#values),*])
    };
    match forces {
        Forces::Holding(torques) => {
            let torques = row(torques);
            quote!(Holding { torques: #torques })
        }
        Forces::InverseDynamics(found) => {
            let (torques, transmission) = (row(&found.torques), row(&found.transmission));
            let velocity_ratios = found.velocity_ratios.iter().map(row);
            let reactions = found.reactions.iter().map(|reaction| {
                let [x, y, torque] = reaction.map(|part| scope.expression(part));
                quote!(Reaction { x: #x, y: #y, torque: #torque })
            });
            quote! {
                Forces {
                    torques: #torques,
                    reactions: [#(#reactions),*],
                    velocity_ratios: [#(#velocity_ratios),*],
                    transmission: #transmission,
                }
            }
        }
        Forces::Inertia(inertia) => {
            let (matrix, drive) = (inertia.matrix.iter().map(row), row(&inertia.drive));
            let [kinetic, potential] = inertia.energy.map(|part| scope.expression(part));
            quote! {
                Inertia { matrix: [#(#matrix),*], drive: #drive, kinetic: #kinetic, potential: #potential }
            }
        }
    }
}

/// The type of the rates or forces that a program computes.
pub(in crate::emit) fn outcome_type(program: &Program) -> TokenStream {
    let scalar = scalar(program.precision);
    let (links, motors) = (integer(program.links.len()), integer(program.motors.len()));
    match program.results() {
        Some(Results::Rates(rates)) if rates.accelerations.is_some() => {
            quote!(([Velocity<#scalar>; #links], [Acceleration<#scalar>; #links]))
        }
        Some(Results::Rates(_)) => quote!([Velocity<#scalar>; #links]),
        Some(Results::Forces { forces, .. }) => match forces {
            Forces::Holding(_) => quote!(Holding<#scalar, #motors>),
            Forces::InverseDynamics(found) => {
                // One row for each motor, and there is one at least.
                let loads = found.velocity_ratios[0].len();
                let sizes = [found.reactions.len(), loads, found.transmission.len()].map(integer);
                quote!(Forces<#scalar, #motors, #(#sizes),*>)
            }
            Forces::Inertia(_) => quote!(Inertia<#scalar, #motors>),
        },
        None | Some(Results::Sensitivity(_)) => {
            bug!("the program computes neither rates nor forces")
        }
    }
}
