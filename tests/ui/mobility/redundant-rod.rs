//! A parallelogram is braced by a third crank of the same length: it would move only because lengths match.

use mech_runtime::mechanism;

mechanism! {
    struct Parallelogram;

    link left;
    link middle;
    link right;
    link beam;

    joint a = revolute(ground, left) at (0.0, 0.0);
    joint b = revolute(ground, middle) at (2.0, 0.0);
    joint c = revolute(ground, right) at (4.0, 0.0);
    joint d = revolute(left, beam) at (0.0, 1.0);
    joint e = revolute(middle, beam) at (2.0, 1.0);
    joint f = revolute(right, beam) at (4.0, 1.0);

    motor a;
}

fn main() {}
