//! A six-bar linkage, declared as in a drawing.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A Watt six-bar: two four-bar loops that share a ternary link.
    pub struct Watt;

    link crank;
    link coupler;
    link bell_crank;
    link connecting_rod;
    link rocker;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (0.0, 1.2);
    joint c = revolute(coupler, bell_crank) at (3.7, 2.2);
    joint d = revolute(ground, bell_crank) at (4.0, 0.0);
    joint e = revolute(bell_crank, connecting_rod) at (6.4, 3.0);
    joint f = revolute(connecting_rod, rocker) at (8.6, 0.7);
    joint g = revolute(ground, rocker) at (6.7, 0.0);
    motor a;
    effects { acceleration; overlay; }
}

exhibited!(Watt, "watt-six-bar", "watt.rs", motion);

/// One turn of the crank.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [phase * T::TURN]
}
