//! What does not exist, does not move or has no coordinate is not shown.

use mech_runtime::mechanism;

mechanism! {
    struct Press;

    ground { point o = (0.0, 0.0); line bore = (0.0, 0.0) -> (1.0, 0.0); point p = (-3.0, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link rod { point big_end = (0.0, 0.0); point small_end = (4.0, 0.0); }
    link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (1.0, 0.0); }
    link wheel { point shaft = (0.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, rod.big_end);
    joint c = revolute(rod.small_end, piston.pin);
    joint h = prismatic(ground.bore, piston.axis);
    joint e = revolute(ground.p, wheel.shaft);
    joint mesh = gear(crank, wheel, 20 : 40);

    motor a;
    start { a = 60 deg; rod near 0 deg; }
    show pistn, rod.smal_end, h.pin, ground, ground.o, ground.bore, piston.axis, mesh;
}

fn main() {}
