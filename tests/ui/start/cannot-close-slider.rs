//! The rod does not reach the bore.

use mech_runtime::mechanism;

mechanism! {
    struct Slider;

    ground { point o = (0.0, 5.0); line bore = (0.0, 0.0) -> (1.0, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link rod { point big_end = (0.0, 0.0); point small_end = (4.0, 0.0); }
    link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (1.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, rod.big_end);
    joint c = revolute(rod.small_end, piston.pin);
    joint d = prismatic(ground.bore, piston.axis);

    motor a;
}

fn main() {}
