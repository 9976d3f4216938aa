//! The place of a joint was copied from the line above.

use mech_runtime::mechanism;

mechanism! {
    struct SliderCrank;

    link crank;
    link rod;
    link slider;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, rod) at (0.8, 0.6);
    joint c = revolute(rod, slider) at (0.8, 0.6);
    joint d = prismatic(ground, slider) at (4.0, 0.0) along (1.0, 0.0);

    motor a;
}

fn main() {}
