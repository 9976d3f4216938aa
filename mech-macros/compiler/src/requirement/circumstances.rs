//! How a mechanism moves where rates and forces are measured, and what computes these.
//!
//! Motors that follow a law have the rate of the law. Without laws one motor moves at a rate of 1, and forces are those at rest: as tables
//! have them.

use crate::compile::compile;
use crate::compiled::Compiled;
use crate::model::{Effects, Model, Quantity, Requirement};
use crate::program::{Circumstances, Op, Program, build_timing};
use crate::structure::RequirementTrouble;
use std::borrow::Cow;

/// The rates of all motors, and those for which forces are measured.
pub(super) struct Rates {
    own: Vec<f64>,
    pushed: Vec<f64>,
}

impl Rates {
    pub(super) fn of(model: &Model, requirement: &Requirement) -> Result<Self, RequirementTrouble> {
        let at_rest = vec![0.0; model.motors.len()];
        if model.lawful_motors().next().is_some() {
            let is_asked = requirement.is_about_rates() || requirement.is_about_forces();
            let rates = if is_asked { by_laws(model)? } else { at_rest };
            return Ok(Self {
                own: rates.clone(),
                pushed: rates,
            });
        }
        let mut own = at_rest.clone();
        if requirement.is_about_rates() {
            let moving = requirement.moving_motor(model);
            let moving = moving.map_err(|motors| RequirementTrouble::NoRate { motors })?;
            own[moving.index()] = 1.0;
        }
        Ok(Self {
            own,
            pushed: at_rest,
        })
    }

    /// The circumstances of a requirement, with a program that computes forces.
    pub(super) fn circumstances<'a>(
        &self,
        requirement: &'a Requirement,
        forces: Option<&'a Program>,
    ) -> Circumstances<'a> {
        Circumstances {
            rates: self.own.clone(),
            pushed: self.pushed.clone(),
            loads: &requirement.loads,
            forces,
        }
    }

    /// The program that computes the forces which a requirement measures; nothing if it measures none.
    pub(super) fn forces<'a>(
        &self,
        model: &Model,
        compiled: &'a Compiled,
        requirement: &Requirement,
    ) -> Result<Option<Cow<'a, Program>>, RequirementTrouble> {
        if !requirement.quantities().any(Quantity::needs_equilibrium) {
            return Ok(None);
        }
        let forced = &compiled.forced;
        let mut quantities = requirement.quantities();
        let is_within = quantities.any(|one| matches!(one, Quantity::Reaction(..)));
        let is_still = self.pushed.iter().all(|rate| *rate == 0.0);
        let holding = forced.holding.as_ref().filter(|_| is_still);
        // Virtual work takes fewer operations, and tells no reaction.
        let found = if is_within {
            forced.inverse_dynamics.as_ref().map(Cow::Borrowed)
        } else {
            let found = holding.or(forced.inverse_dynamics.as_ref());
            found
                .map(Cow::Borrowed)
                .or_else(|| inertia(model).map(Cow::Owned))
        };
        found.map(Some).ok_or(RequirementTrouble::NoForces)
    }
}

/// The program of virtual work for a mechanism that moves.
fn inertia(model: &Model) -> Option<Program> {
    let effects = Effects {
        dynamics: true,
        ..model.effects
    };
    let moved = Model {
        effects,
        ..model.clone()
    };
    compile(&moved).ok()?.forced.inertia
}

/// The rates of all motors by their laws, which do not change.
fn by_laws(model: &Model) -> Result<Vec<f64>, RequirementTrouble> {
    let effects = Effects {
        velocity: true,
        ..Effects::default()
    };
    let timing = build_timing(&Model {
        effects,
        ..model.clone()
    });
    let mut rates = vec![0.0; model.motors.len()];
    let Some(timing) = timing else {
        return Ok(rates);
    };
    for law in &timing.motors {
        let motor = law.motor;
        let rate = law.rate.map(|rate| timing.program.node(rate).op);
        let Some(Op::Constant(rate)) = rate else {
            return Err(RequirementTrouble::UnevenLaw { motor });
        };
        rates[motor.index()] = rate.get();
    }
    Ok(rates)
}
