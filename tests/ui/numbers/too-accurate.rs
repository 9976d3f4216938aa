//! Single precision has no more than seven digits; no way to solve the loop gives nine.

use mech_runtime::mechanism;

mechanism! {
    struct FourBar: f32;
    link crank;
    link coupler;
    link rocker;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
    motor a by 1 deg;
    accuracy 1e-9;
}

fn main() {}
