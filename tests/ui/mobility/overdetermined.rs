//! A plate is bolted on twice.

use mech_runtime::mechanism;

mechanism! {
    struct Arm;

    ground { point base = (0.0, 0.0); }
    link arm { point shoulder = (0.0, 0.0); point hole = (1.0, 0.0); point slot = (2.0, 0.0); }
    link plate { point hole = (0.0, 0.0); point slot = (1.0, 0.0); }

    joint shoulder = revolute(ground.base, arm.shoulder);
    joint bolt = revolute(arm.hole, plate.hole);
    joint screw = revolute(arm.slot, plate.slot);

    motor shoulder;
}

fn main() {}
