//! Two braces, each of which would hold the four-bar alone.

use mech_runtime::mechanism;

mechanism! {
    struct FourBar;

    link crank;
    link coupler;
    link rocker;
    link brace;
    link strut;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (0.5, 1.0);
    joint c = revolute(coupler, rocker) at (3.2, 2.0);
    joint d = revolute(ground, rocker) at (3.5, 0.0);
    joint e = revolute(ground, brace) at (1.0, 0.0);
    joint f = revolute(coupler, brace) at (1.6, 1.6);
    joint g = revolute(ground, strut) at (2.0, -0.5);
    joint h = revolute(coupler, strut) at (2.5, 2.0);

    motor a;
}

fn main() {}
