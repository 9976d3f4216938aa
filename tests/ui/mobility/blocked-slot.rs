//! A second pin in the same slot holds the arm still.

use mech_runtime::mechanism;

mechanism! {
    struct Arm;

    ground { point o = (0.0, 0.0); point p = (0.0, -2.0); point stop = (1.5, -0.5); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link arm { point shaft = (0.0, 0.0); line way = (0.0, 0.0) -> (1.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint s = slot(crank.pin, arm.way);
    joint t = slot(ground.stop, arm.way);
    joint d = revolute(ground.p, arm.shaft);

    motor a;
}

fn main() {}
