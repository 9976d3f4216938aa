//! No link carries both wheels of a gear.

use mech_runtime::mechanism;

mechanism! {
    struct Gears;

    ground { point o = (0.0, 0.0); point p = (3.0, 0.0); }
    link pinion { point shaft = (0.0, 0.0); }
    link arm { point pivot = (0.0, 0.0); point shaft = (1.0, 0.0); }
    link wheel { point shaft = (0.0, 0.0); }

    joint a = revolute(ground.o, pinion.shaft);
    joint b = revolute(ground.p, arm.pivot);
    joint c = revolute(arm.shaft, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 40);

    motor a;
    motor b;
}

fn main() {}
