//! The link that is named as carrier holds only one of the wheels.

use mech_runtime::mechanism;

mechanism! {
    struct Gears;

    ground { point o = (0.0, 0.0); point p = (3.0, 0.0); }
    link pinion { point shaft = (0.0, 0.0); }
    link wheel { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link flag { point pin = (0.0, 0.0); }

    joint a = revolute(ground.o, pinion.shaft);
    joint b = revolute(ground.p, wheel.shaft);
    joint c = revolute(wheel.pin, flag.pin);
    joint mesh = gear(pinion, wheel, 20 : 40 on flag);

    motor a;
    motor c;
}

fn main() {}
