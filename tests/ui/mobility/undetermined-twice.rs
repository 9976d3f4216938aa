//! An arm of three joints has one motor.

use mech_runtime::mechanism;

mechanism! {
    struct Arm;

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
