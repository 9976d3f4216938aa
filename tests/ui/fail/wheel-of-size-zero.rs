//! A wheel of a gear has no teeth.

use mech_runtime::mechanism;

mechanism! {
    struct Gears;

    ground { point o = (0.0, 0.0); point p = (3.0, 0.0); }
    link pinion { point shaft = (0.0, 0.0); }
    link wheel { point shaft = (0.0, 0.0); }

    joint a = revolute(ground.o, pinion.shaft);
    joint b = revolute(ground.p, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 0);

    motor a;
}

fn main() {}
