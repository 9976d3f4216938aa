//! A rod of a given length does not fit between two links of the drawing.

use mech_runtime::mechanism;

mechanism! {
    struct FourBar;

    link crank { point pin = (1.0, 0.0); }
    link rocker { point pin = (4.0, 2.0); }
    link rod { point left = (0.0, 0.0); point right = (3.0, 0.0); }

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint d = revolute(ground, rocker) at (4.0, 0.0);
    joint b = revolute(crank.pin, rod.left);
    joint c = revolute(rocker.pin, rod.right);

    motor a;
}

fn main() {}
