//! A parallelogram with a third crank whose pivot is a thousandth off: it does not move at all.

use mech_runtime::mechanism;

mechanism! {
    struct Parallelogram;

    link left;
    link middle;
    link right;
    link beam;

    joint a = revolute(ground, left) at (0.0, 0.0);
    joint b = revolute(ground, middle) at (2.0, 0.0);
    joint c = revolute(ground, right) at (4.001, 0.0);
    joint d = revolute(left, beam) at (0.5, 1.0);
    joint e = revolute(middle, beam) at (2.5, 1.0);
    joint f = revolute(right, beam) at (4.5, 1.0);

    motor a;
    allow redundant;
}

fn main() {}
