//! The fields and methods of forces.

mod actions;
mod dynamics;
mod inverse_dynamics;

use super::Parts;
use super::costs::extra_cost;
use super::emitter::Emitter;
use super::step::step;

/// Loads, springs, and the forces or the dynamics that are asked for.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    if !emitter.model.effects.needs_actions() {
        return Parts::default();
    }
    let forced = &emitter.compiled.forced;
    let programs = [
        (&forced.holding, "TORQUES_COST", "the torques that hold it"),
        (&forced.inverse_dynamics, "FORCES_COST", "all forces in it"),
        (&forced.inertia, "INERTIA_COST", "its inertia and what drives it"),
    ];
    let derived = programs.into_iter().filter_map(|(program, name, what)| {
        let program = program.as_ref()?;
        Some(Parts {
            methods: extra_cost(emitter, program, name, what),
            modules: step(emitter.krate, program),
            ..Parts::default()
        })
    });
    [
        actions::loads(emitter),
        actions::springs(emitter),
        inverse_dynamics::holding(emitter),
        inverse_dynamics::forces(emitter),
        dynamics::dynamics(emitter),
    ]
    .into_iter()
    .chain(derived)
    .collect()
}
