//! Every bad statement is reported in one go.

use mech_runtime::mechanism;

mechanism! {
    struct FourBar;

    const THROW = 1.0 +;

    ground { point o = (0.0, 0.0) point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); piont pin = (THROW, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0; 1.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = 2.5; }

    joint a = revolute(ground.o, crank.shaft)
    joint b = hinge(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rockr.pin);
    joint d = revolute(ground.p);

    motor a
    start { a = 60 degrees; coupler at 30 deg; }
}

fn main() {}
