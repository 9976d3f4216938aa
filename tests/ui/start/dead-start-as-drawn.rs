//! A four-bar driven at its rocker, and drawn where crank and coupler are in line.

use mech_runtime::mechanism;

mechanism! {
    struct FourBar;

    link crank;
    link coupler;
    link rocker;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (1.0, 0.0);
    joint c = revolute(coupler, rocker) at (4.0, 0.0);
    joint d = revolute(ground, rocker) at (4.0, -2.0);

    motor d;
}

fn main() {}
