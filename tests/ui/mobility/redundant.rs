//! Mechanisms that move only as long as lengths match.

use mech_runtime::mechanism;

// A parallelogram is braced by a third crank of the same length: it would move only because lengths match.
mechanism! {
    struct RedundantRod;

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

// A parallelogram with a third crank whose pivot is a thousandth off: it does not move at all.
mechanism! {
    struct RedundantRodOffByAThousandth;

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

// It moves only as long as its lengths match.
mechanism! {
    struct ParamThatMatches;
    param third_foot = 2;
    link first;
    link second;
    link third;
    link rail;
    joint a = revolute(ground, first) at (0, 0);
    joint b = revolute(ground, second) at (4, 0);
    joint c = revolute(ground, third) at (third_foot, 0);
    joint d = revolute(first, rail) at (0.5, 1);
    joint e = revolute(second, rail) at (4.5, 1);
    joint f = revolute(third, rail) at (2.5, 1);
    motor a;
    allow redundant;
    effects { sensitivity; }
}

fn main() {
    // Nothing else turns red.
    let rails = ParamThatMatches::new();
    let _ = rails.sensitivities();
    let _ = rails.b_sensitivity();
    let _ = rails.rail_sensitivity();
}
