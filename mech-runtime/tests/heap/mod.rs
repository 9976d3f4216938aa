//! Pictures on the heap are those of a fixed size, and may be as large as memory is.

mod alike;
mod large;
mod refused;
mod values;

use mech_runtime::mechanism;

mechanism! {
    struct Arm;
    ground { circle (0, 0) radius 0.5; }
    link upper { bar [(0, 0), (2, 0)] width 0.4 on plane 1; }
    link lower { polygon [(1.9, -0.2), (3.5, 0), (1.9, 0.2)] on plane 2; }
    joint shoulder = revolute(ground, upper) at (0, 0);
    joint elbow = revolute(upper, lower) at (2, 0);
    motor shoulder; motor elbow;
}
