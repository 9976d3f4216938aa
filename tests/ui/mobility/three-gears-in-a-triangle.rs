//! Three external gears in a ring lock each other.

use mech_runtime::mechanism;

mechanism! {
    struct Triangle;

    ground { point a = (0.0, 0.0); point b = (2.0, 0.0); point c = (1.0, 1.7); }
    link first { point shaft = (0.0, 0.0); }
    link second { point shaft = (0.0, 0.0); }
    link third { point shaft = (0.0, 0.0); }

    joint x = revolute(ground.a, first.shaft);
    joint y = revolute(ground.b, second.shaft);
    joint z = revolute(ground.c, third.shaft);
    joint mesh = gear(first, second, 20 : 20);
    joint bite = gear(second, third, 20 : 20);
    joint lock = gear(third, first, 20 : 20);

    motor x;
}

fn main() {}
