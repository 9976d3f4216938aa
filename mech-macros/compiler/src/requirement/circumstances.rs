//! How a mechanism moves where rates and forces are measured, and what computes these.
//!
//! Motors that follow a law have the rate of the law. Where that changes, the time decides where they are and how fast they are. Without
//! laws one motor moves at a rate of 1, and forces are those at rest: as tables have them.

use super::times::Timed;
use crate::compile::compile;
use crate::compiled::Compiled;
use crate::model::{Effects, Model, Quantity, Requirement};
use crate::program::{Circumstances, Motion, Op, Program, Timing, build_timing};
use crate::structure::RequirementTrouble;
use std::borrow::Cow;

/// How all motors move.
pub(super) enum Setting {
    /// Wherever they are, at rates that do not change.
    Even {
        /// The rates of all motors.
        own: Vec<f64>,
        /// Those for which forces are measured.
        pushed: Vec<f64>,
    },
    /// By their laws, through times.
    InTime(Box<Timed>),
}

impl Setting {
    pub(super) fn of(
        model: &Model,
        compiled: &Compiled,
        requirement: &Requirement,
    ) -> Result<Self, RequirementTrouble> {
        let at_rest = vec![0.0; model.motors.len()];
        let is_asked = requirement.is_about_rates() || requirement.is_about_forces();
        let laws = with_slopes(model);
        if let Some(laws) = laws.filter(|_| is_asked || requirement.times.is_some()) {
            let even = even_rates(model, &laws).filter(|_| requirement.times.is_none());
            let Some(rates) = even else {
                let timed = Timed::new(model, &compiled.program, laws, requirement)?;
                return Ok(Self::InTime(Box::new(timed)));
            };
            return Ok(Self::Even { own: rates.clone(), pushed: rates });
        }
        let mut own = at_rest.clone();
        if requirement.is_about_rates() {
            let moving = requirement.moving_motor(model);
            let moving = moving.map_err(|motors| RequirementTrouble::NoRate { motors })?;
            own[moving.index()] = 1.0;
        }
        Ok(Self::Even { own, pushed: at_rest })
    }

    /// The times through which laws are followed, if they decide.
    pub(super) fn timed(&self) -> Option<&Timed> {
        match self {
            Self::Even { .. } => None,
            Self::InTime(timed) => Some(timed),
        }
    }

    /// The program of positions that is searched through.
    pub(super) fn positions<'a>(&'a self, compiled: &'a Compiled) -> &'a Program {
        self.timed().map_or(&compiled.program, |timed| &timed.laws.program)
    }

    /// The circumstances of a requirement, with a program that computes forces.
    pub(super) fn circumstances<'a>(
        &'a self,
        requirement: &'a Requirement,
        forces: Option<&'a Program>,
    ) -> Circumstances<'a> {
        let motion = match self {
            Self::Even { own, pushed } => {
                Motion::Even { rates: own.clone(), pushed: pushed.clone() }
            }
            Self::InTime(timed) => Motion::InTime(&timed.laws),
        };
        Circumstances { motion, loads: &requirement.loads, forces }
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
        let is_still = match self {
            Self::Even { pushed, .. } => pushed.iter().all(|rate| *rate == 0.0),
            Self::InTime(_) => false,
        };
        let holding = forced.holding.as_ref().filter(|_| is_still);
        // Virtual work takes fewer operations, and tells no reaction.
        let found = if is_within {
            forced.inverse_dynamics.as_ref().map(Cow::Borrowed)
        } else {
            let found = holding.or(forced.inverse_dynamics.as_ref());
            found.map(Cow::Borrowed).or_else(|| inertia(model).map(Cow::Owned))
        };
        found.map(Some).ok_or(RequirementTrouble::NoForces)
    }
}

/// The program of virtual work for a mechanism that moves.
fn inertia(model: &Model) -> Option<Program> {
    let effects = Effects { dynamics: true, ..model.effects };
    let moved = Model { effects, ..model.clone() };
    compile(&moved).ok()?.forced.inertia
}

/// The laws of motors, with their rates; none if no motor has a law.
fn with_slopes(model: &Model) -> Option<Timing> {
    let effects = Effects { velocity: true, ..Effects::default() };
    build_timing(&Model { effects, ..model.clone() })
}

/// The rates of all motors by their laws; nothing if any of them changes.
fn even_rates(model: &Model, laws: &Timing) -> Option<Vec<f64>> {
    let mut rates = vec![0.0; model.motors.len()];
    for law in &laws.motors {
        let rate = law.rate.map(|rate| laws.program.node(rate).op);
        let Some(Op::Constant(rate)) = rate else {
            return None;
        };
        rates[law.motor.index()] = rate.get();
    }
    Some(rates)
}
