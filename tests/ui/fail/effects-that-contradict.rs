//! Effects that contradict each other, or are not for each other yet.

use mech_runtime::mechanism;

mechanism! {
    struct Both;
    ground { point o = (0, 0); }
    link arm { point shaft = (0, 0); mass 1 at (1, 0); }
    joint a = revolute(ground.o, arm.shaft);
    motor a = 2 * PI * t;
    effects { dynamics; }
}

mechanism! {
    struct Heavy;
    param reach = 2;
    ground { point o = (0, 0); }
    link arm { point shaft = (0, 0); point tip = (reach, 0); mass 1 at (1, 0); }
    joint a = revolute(ground.o, arm.shaft);
    motor a;
    effects { force; }
}

mechanism! {
    struct Drawn;
    param reach = 2;
    ground { point o = (0, 0); }
    link arm { point shaft = (0, 0); point tip = (reach, 0); }
    joint a = revolute(ground.o, arm.shaft);
    motor a;
    effects { overlay; }
}

mechanism! {
    struct Timed;
    param reach = 2;
    ground { point o = (0, 0); }
    link arm { point shaft = (0, 0); point tip = (reach, 0); }
    joint a = revolute(ground.o, arm.shaft);
    motor a = t;
}

fn main() {}
