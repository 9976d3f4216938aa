//! Motors that are missing, or too many.

use mech_runtime::mechanism;

// Nothing drives the mechanism.
mechanism! {
    struct NoMotor;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    start { coupler near 30 deg; }
}

// Nothing drives a mechanism that needs two motors.
mechanism! {
    struct NoMotorForSeveral;

    ground { point base = (0.0, 0.0); }
    link upper { point shoulder = (0.0, 0.0); point elbow = (1.0, 0.0); }
    link lower { point elbow = (0.0, 0.0); point hand = (1.0, 0.0); }

    joint shoulder = revolute(ground.base, upper.shoulder);
    joint elbow = revolute(upper.elbow, lower.elbow);
}

// A second motor drives what the first one drives already.
mechanism! {
    struct TooManyMotors;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor a;
    motor d;
    start { a = 60 deg; coupler near 30 deg; }
}

// A five-bar has two degrees of freedom, and one motor.
mechanism! {
    struct Undetermined;

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

// An arm of three joints has one motor.
mechanism! {
    struct UndeterminedTwice;

    ground { point base = (0.0, 0.0); }
    link upper { point shoulder = (0.0, 0.0); point elbow = (1.0, 0.0); }
    link lower { point elbow = (0.0, 0.0); point wrist = (1.0, 0.0); }
    link hand { point wrist = (0.0, 0.0); }

    joint shoulder = revolute(ground.base, upper.shoulder);
    joint elbow = revolute(upper.elbow, lower.elbow);
    joint wrist = revolute(lower.wrist, hand.wrist);

    motor elbow;
}

fn main() {}
