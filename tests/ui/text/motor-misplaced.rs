//! Two motors on what has one freedom, none on what hangs beside it.

use mech_runtime::mechanism;

mechanism! {
    struct FourBar;

    link crank;
    link coupler;
    link rocker;
    link flag;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (0.5, 1.0);
    joint c = revolute(coupler, rocker) at (3.2, 2.0);
    joint d = revolute(ground, rocker) at (3.5, 0.0);
    joint e = revolute(rocker, flag) at (3.3, 1.0);

    motor a;
    motor d;
}

fn main() {}
