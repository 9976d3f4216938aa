//! Numbers of forces, rates and laws that the scalar type does not hold, and the statement that makes them.

use crate::compiled::Compiled;
use crate::evaluate::{Machine, Stop};
use crate::model::{Model, MotorId, Precision};
use crate::program::{Program, Real, Results, build_timing};
use crate::structure::{Diagnosis, Extreme};

/// Finds numbers of a program, or forces at the start, that its scalar type does not hold.
pub(super) fn overflow(model: &Model, compiled: &Compiled) -> Option<Diagnosis> {
    let derived = [
        &compiled.moving,
        &compiled.forced.holding,
        &compiled.forced.inverse_dynamics,
        &compiled.forced.inertia,
        &compiled.sensitive,
    ];
    let derived = || derived.into_iter().flatten();
    let asks_forces = compiled.forced != <_>::default();
    let fits = derived().all(Program::fits)
        && compiled.timing.iter().all(|timing| timing.program.fits())
        && derived().all(|program| match program.precision {
            Precision::F32 => is_finite_at_start::<f32>(program),
            Precision::F64 => is_finite_at_start::<f64>(program),
        });
    let all = extremes(model);
    let is_lost = |(_, number): &(Extreme, f64)| number.abs() < model.precision.least();
    if fits && !(asks_forces && all.iter().any(is_lost)) {
        return None;
    }
    if let Some(timing) = &compiled.timing
        && !timing.program.fits()
    {
        return Some(Diagnosis::Overflow { culprit: lawful_culprit(model) });
    }
    let far = |number: f64| number.abs().log10().abs();
    let worst = all.into_iter().max_by(|(_, a), (_, b)| far(*a).total_cmp(&far(*b)));
    Some(Diagnosis::Overflow { culprit: worst.map(|(culprit, _)| culprit) })
}

/// Whether the forces at the start are numbers, if nothing moves and no load acts.
fn is_finite_at_start<T: Real>(program: &Program) -> bool {
    let Some(Results::Forces { loads, .. }) = program.results() else {
        return true;
    };
    let still = vec![T::ZERO; program.inputs()];
    let loads = vec![T::ZERO; loads.len()];
    let machine = Machine::<T>::new(program);
    machine.forces(&still[..program.motors.len()], &still[..program.motors.len()], &loads)
        != Err(Stop::Overflow)
}

/// All numbers that forces are made from, but for zeros, and whose they are.
fn extremes(model: &Model) -> Vec<(Extreme, f64)> {
    let masses = model.link_ids().filter_map(|link| Some((link, model.link(link).mass?)));
    let masses = masses.flat_map(|(link, mass)| {
        let numbers = [mass.mass, mass.inertia, mass.center[0], mass.center[1]];
        numbers.map(|number| (Extreme::Mass(link), number))
    });
    let actions = &model.actions;
    let springs = actions.springs.iter().enumerate();
    let springs = springs.flat_map(|(number, spring)| {
        [spring.stiffness, spring.rest].map(|value| (Extreme::Spring(number), value))
    });
    let dampers = actions.dampers.iter().enumerate();
    let dampers = dampers.map(|(number, damper)| (Extreme::Damper(number), damper.damping));
    let gravity = actions.gravity.into_iter().flatten();
    let gravity = gravity.map(|part| (Extreme::Gravity, part));
    let all = masses.chain(springs).chain(dampers).chain(gravity);
    all.filter(|(_, number)| *number != 0.0).collect()
}

/// The first motor whose law alone is too large.
fn lawful_culprit(model: &Model) -> Option<Extreme> {
    let is_too_large = |id: &MotorId| {
        let mut alone = model.clone();
        for (number, motor) in alone.motors.iter_mut().enumerate() {
            if number != id.index() {
                motor.law = None;
            }
        }
        build_timing(&alone).is_some_and(|timing| !timing.program.fits())
    };
    model.motor_ids().find(is_too_large).map(Extreme::Law)
}
