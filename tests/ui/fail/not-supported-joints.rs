//! Joints that are to come.

use mech_runtime::mechanism;

mechanism! {
    struct Machine;

    ground { point o = (0.0, 0.0); point p = (3.0, 0.0); line bed = (0.0, 0.0) -> (1.0, 0.0); }
    link pinion { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link bar { line axis = (0.0, 0.0) -> (1.0, 0.0); }
    link pulley { point shaft = (0.0, 0.0); }
    link handle;
    link wheel;

    joint a = revolute(ground.o, pinion.shaft);
    joint b = prismatic(ground.bed, bar.axis);
    joint c = slot(pinion.pin, bar.axis);
    joint d = rack(pinion, bar, radius 0.5);
    joint e = belt(pinion, pulley, 1.0 : 3.0);
    joint f = weld(pulley, handle);
    joint g = gear(pinion, wheel, 20 : 40 on ground);

    motor a;
}

fn main() {}
