//! Nothing guides the bar of a rack.

use mech_runtime::mechanism;

mechanism! {
    struct Rack;

    ground { point o = (0.0, 0.0); point p = (0.0, 0.5); }
    link pinion { point shaft = (0.0, 0.0); }
    link bar { point end = (0.0, 0.0); }

    joint a = revolute(ground.o, pinion.shaft);
    joint b = revolute(ground.p, bar.end);
    joint teeth = rack(pinion, bar, radius 0.5);

    motor a;
}

fn main() {}
