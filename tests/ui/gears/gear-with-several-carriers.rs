//! Both wheels of a gear turn on the ground as well as on a bracket.

use mech_runtime::mechanism;

mechanism! {
    struct Gears;

    ground { point o = (0.0, 0.0); point p = (3.0, 0.0); }
    link bracket { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link pinion { point shaft = (0.0, 0.0); }
    link wheel { point shaft = (0.0, 0.0); }

    joint a = revolute(ground.o, pinion.shaft);
    joint b = revolute(ground.p, wheel.shaft);
    joint c = revolute(bracket.left, pinion.shaft);
    joint d = revolute(bracket.right, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 40);

    motor a;
}

fn main() {}
