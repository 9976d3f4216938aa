//! A pin slides in a slot and nothing says where.

use mech_runtime::mechanism;

mechanism! {
    struct Arm;

    ground { point o = (0.0, 0.0); point p = (0.0, -2.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link arm { point shaft = (0.0, 0.0); line way = (0.0, 0.0) -> (1.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint s = slot(crank.pin, arm.way);
    joint d = revolute(ground.p, arm.shaft);
}

fn main() {}
