//! The coordinate of a motor is given: nothing has to be computed.

use mech_runtime::mechanism;

mechanism! {
    struct Crank;

    link crank;
    joint a = revolute(ground, crank) at (0.0, 0.0);
    motor a;
    show a;
}

fn main() {}
