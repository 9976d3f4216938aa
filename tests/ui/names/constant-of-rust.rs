//! Constants that Rust declares.

use mech_runtime::mechanism;

const THROW: f64 = 1.0;

mechanism! {
    struct Crank;
    link crank { point pin = (THROW, 0); }
    joint a = revolute(ground, crank) at (0, 0);
    motor a = std::f64::consts::PI * t;
}

fn main() {}
