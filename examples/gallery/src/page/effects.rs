//! Effects of a mechanism as values.

use crate::Scene;
use mech_runtime::overlay::Arrows;
use mech_runtime::{Blocked, Mechanism, Overlay};

/// The methods of a mechanism with `effects { acceleration; overlay; }`, which no trait has. [`all_effects!`](crate::all_effects) makes
/// them.
#[derive(Clone)]
pub struct Effects<M: Mechanism<Scalar = f64>> {
    /// Moves the motors to these values, with these rates and second rates.
    pub move_with: MoveWith<M>,
    /// Draws its symbols.
    pub draw_overlay: fn(&M, &mut Scene, &Overlay),
    /// Draws velocities.
    pub draw_velocities: Draw<M>,
    /// Draws accelerations.
    pub draw_accelerations: Draw<M>,
}

/// A function that moves a mechanism to motor values with rates and second rates.
pub type MoveWith<M> = fn(
    &mut M,
    <M as Mechanism>::Motors,
    <M as Mechanism>::Motors,
    <M as Mechanism>::Motors,
) -> Result<(), Blocked<<M as Mechanism>::Motors>>;

/// A function that draws arrows.
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
