//! Loops that wait for each other are solved together when that is allowed.

use mech_runtime::{Mechanism, mechanism};

mechanism! {
    struct StephensonFar;
    link crank;
    link coupler;
    link rocker;
    link rod;
    link driver;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.7, 1.2);
    joint c = revolute(coupler, rocker) at (3.6, 2.4);
    joint d = revolute(ground, rocker) at (4, 0);
    joint e = revolute(coupler, rod) at (2.2, 3.6);
    joint f = revolute(rod, driver) at (5.6, 4.6);
    joint g = revolute(ground, driver) at (6.4, 1.6);
    motor g;
    allow coupled;
}

fn main() {
    let mut linkage = StephensonFar::new();
    linkage.move_to([0.05]).expect("it moves");
    assert!(linkage.a().abs() > 1e-3);
}
