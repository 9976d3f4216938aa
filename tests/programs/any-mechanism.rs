//! Code that takes any mechanism.

use mech_runtime::{Mechanism, mechanism};

mechanism! {
    pub struct FourBar;

    link crank;
    link coupler;
    link rocker;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (0.5, 0.8);
    joint c = revolute(coupler, rocker) at (3.0, 2.0);
    joint d = revolute(ground, rocker) at (3.5, 0.0);

    motor a;
}

fn name<M: Mechanism>(mechanism: &M) -> (&'static str, usize) {
    (M::NAME, mechanism.poses().len())
}

fn main() {
    assert_eq!(name(&FourBar::new()), ("FourBar", 3));
    assert_eq!(FourBar::MOTORS, ["a"]);
}
