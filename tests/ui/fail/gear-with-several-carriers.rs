//! Both wheels of a gear turn on the ground as well as on an arm.

use mech_runtime::mechanism;

mechanism! {
    struct Gears;

    ground { point o = (0.0, 0.0); }
    link arm { point pivot = (0.0, 0.0); }
    link sun { point shaft = (0.0, 0.0); }
    link ring { point shaft = (0.0, 0.0); }

    joint a = revolute(ground.o, arm.pivot);
    joint b = revolute(arm.pivot, sun.shaft);
    joint c = revolute(arm.pivot, ring.shaft);
    joint mesh = gear(sun, ring, 20 : 40);

    motor a;
    motor b;
}

fn main() {}
