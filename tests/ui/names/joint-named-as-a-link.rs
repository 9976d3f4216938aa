//! A joint takes the name of a link: both would be the same method.

use mech_runtime::mechanism;

mechanism! {
    struct FourBar;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint rocker = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor a;
    motor rocker;
    start { a = 60 deg; rocker = 30 deg; coupler near 30 deg; }
    spring s = torsional(rocker) stiffness 1;
    show rocker;
}

fn main() {}
