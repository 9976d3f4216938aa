//! A five-bar has two degrees of freedom, and one motor.

use mech_runtime::mechanism;

mechanism! {
    struct FiveBar;

    ground { point o = (0.0, 0.0); point p = (4.0, 0.0); }
    link left_arm { point shaft = (0.0, 0.0); point elbow = (1.5, 0.0); }
    link left_rod { point elbow = (0.0, 0.0); point hand = (2.5, 0.0); }
    link right_rod { point elbow = (0.0, 0.0); point hand = (2.5, 0.0); }
    link right_arm { point shaft = (0.0, 0.0); point elbow = (1.5, 0.0); }

    joint a = revolute(ground.o, left_arm.shaft);
    joint b = revolute(left_arm.elbow, left_rod.elbow);
    joint c = revolute(left_rod.hand, right_rod.hand);
    joint d = revolute(right_arm.elbow, right_rod.elbow);
    joint e = revolute(ground.p, right_arm.shaft);

    motor a;
    start { a = 120 deg; left_rod near 60 deg; }
}

fn main() {}
