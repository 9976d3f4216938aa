//! Statements without an end.

use mech_runtime::mechanism;

mechanism! {
    struct Crank
    const THROW = 1
    link crank { point pin = (THROW, 0) }
    link rod
    joint a = revolute(ground, crank) at (0, 0)
    motor a
    start { a = 0
            crank near 0 }
}

fn main() {}
