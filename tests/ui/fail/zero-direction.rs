//! A direction has no length.

use mech_runtime::mechanism;

mechanism! {
    struct Slider;

    const SLOPE = 0.0;

    ground { line bore = (0.0, 0.0) -> (0.0, 0.0); }
    link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (SLOPE * 2.0, 0.0); }

    joint a = prismatic(ground.bore, piston.axis);

    motor a;
}

fn main() {}
