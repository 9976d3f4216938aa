//! Two links of a robot's hand are braced.

use mech_runtime::mechanism;

mechanism! {
    struct Arm;

    ground { point base = (0.0, 0.0); }
    link arm { point shoulder = (0.0, 0.0); point hip = (1.0, 0.0); point knee = (2.0, 0.0); }
    link thigh { point foot = (0.0, 0.0); point head = (1.0, 0.0); }
    link shin { point foot = (0.0, 0.0); point head = (1.0, 0.0); }

    joint shoulder = revolute(ground.base, arm.shoulder);
    joint hip = revolute(arm.hip, thigh.foot);
    joint knee = revolute(arm.knee, shin.foot);
    joint head = revolute(thigh.head, shin.head);

    motor shoulder;
    motor hip;
}

fn main() {}
