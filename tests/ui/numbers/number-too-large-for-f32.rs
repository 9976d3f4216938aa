//! A number is beyond the largest `f32`.

use mech_runtime::mechanism;

mechanism! {
    struct Arm: f32;

    ground { point base = (0.0, 0.0); }
    link arm { point shoulder = (0.0, 0.0); point hand = (1e39, 0.0); }

    joint shoulder = revolute(ground.base, arm.shoulder);

    motor shoulder;
}

fn main() {}
