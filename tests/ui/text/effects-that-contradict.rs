//! Effects that contradict what a motor does.

use mech_runtime::mechanism;

mechanism! {
    struct Both;
    ground { point o = (0, 0); }
    link arm { point shaft = (0, 0); mass 1 at (1, 0); }
    joint a = revolute(ground.o, arm.shaft);
    motor a = 2 * PI * t;
    effects { dynamics; }
}

fn main() {}
