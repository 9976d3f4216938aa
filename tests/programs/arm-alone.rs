//! A robot arm: no loop at all.

use mech_runtime::mechanism;

mechanism! {
    pub struct Arm;

    ground { point base = (0.0, 0.0); }
    link upper { point shoulder = (0.0, 0.0); point elbow = (2.0, 0.0); }
    link lower { point elbow = (0.0, 0.0); point hand = (1.0, 0.0); }

    joint shoulder = revolute(ground.base, upper.shoulder);
    joint elbow = revolute(upper.elbow, lower.elbow);

    motor shoulder;
    motor elbow;
    start { elbow = 90 deg; }
}

fn main() {
    let mut m = Arm::new();
    let hand = m.lower_hand();
    assert!((hand.x - 2.0).abs() < 1e-12 && (hand.y - 1.0).abs() < 1e-12);
    m.move_to([0.0, 0.0]).expect("it moves");
    assert_eq!(m.lower_hand().x, 3.0);
}
