//! What a mechanism has besides positions, by values instead of methods.

use crate::Scene;
use mech_runtime::overlay::Arrows;
use mech_runtime::{Blocked, Mechanism, Overlay};

/// The methods of a mechanism with `effects { acceleration; overlay; }`, which no trait knows of. Made by
/// [`all_effects!`](crate::all_effects).
#[derive(Clone)]
pub struct Effects<M: Mechanism<Scalar = f64>> {
    /// Moves it to these values of its motors, with these rates and second rates of theirs.
    pub move_with: MoveWith<M>,
    /// Draws its symbols.
    pub draw_overlay: fn(&M, &mut Scene, &Overlay),
    /// Draws velocities.
    pub draw_velocities: Draw<M>,
    /// Draws accelerations.
    pub draw_accelerations: Draw<M>,
}

/// How a mechanism is moved to values of its motors with their rates and second rates.
pub type MoveWith<M> = fn(
    &mut M,
    <M as Mechanism>::Motors,
    <M as Mechanism>::Motors,
    <M as Mechanism>::Motors,
) -> Result<(), Blocked<<M as Mechanism>::Motors>>;

/// How arrows are drawn.
type Draw<M> = fn(&M, &mut Scene, &Arrows<f64>);

/// The [`Effects`] of a mechanism that is declared with `effects { acceleration; overlay; }`.
#[macro_export]
macro_rules! all_effects {
    ($mechanism:ty) => {
        $crate::Effects::<$mechanism> {
            move_with: <$mechanism>::move_with,
            draw_overlay: |mechanism, scene, overlay| mechanism.draw_overlay(scene, overlay),
            draw_velocities: |mechanism, scene, arrows| mechanism.draw_velocities(scene, arrows),
            draw_accelerations: |mechanism, scene, arrows| {
                mechanism.draw_accelerations(scene, arrows);
            },
        }
    };
}
