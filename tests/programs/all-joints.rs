//! A slot, a rack, a belt and a weld.

use mech_runtime::{Mechanism, mechanism};

mechanism! {
    struct SlottedArm;
    ground { point crank_shaft = (0, 2); point arm_shaft = (0, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link arm { point shaft = (0, 0); line way = (0, 0) -> (1, 0); }
    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint x = slot(crank.pin, arm.way);
    joint d = revolute(ground.arm_shaft, arm.shaft);
    motor a;
    start { arm near 63 deg; }
}

mechanism! {
    struct Steering;
    ground { point o = (0, 0); point p = (4, 0); line bed = (0, -0.5) -> (1, 0); }
    link pinion { point shaft = (0, 0); }
    link pulley { point shaft = (0, 0); }
    link handle { point grip = (1, 0); }
    link bar { line axis = (0, 0) -> (1, 0); }
    joint a = revolute(ground.o, pinion.shaft);
    joint b = revolute(ground.p, pulley.shaft);
    joint c = prismatic(ground.bed, bar.axis);
    joint teeth = rack(pinion, bar, radius 0.5);
    joint strap = belt(pinion, pulley, 1.0 : 2.0);
    joint w = weld(pulley, handle);
    motor a;
}

fn main() {
    let mut arm = SlottedArm::new();
    arm.move_to([0.3]).expect("it moves");
    let (x, y) = (0.3_f64.cos(), 2.0 + 0.3_f64.sin());
    assert!((arm.d() - y.atan2(x)).abs() < 1e-12);
    assert!((arm.x().abs() - x.hypot(y)).abs() < 1e-12);

    let mut steering = Steering::new();
    steering.move_to([0.8]).expect("it moves");
    assert!((steering.c().abs() - 0.4).abs() < 1e-12);
    assert!((steering.b() - 0.4).abs() < 1e-12);
    let grip = steering.handle_grip();
    assert!((grip.x - (4.0 + 0.4_f64.cos())).abs() < 1e-12);
}
