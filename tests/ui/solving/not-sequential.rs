//! Joints that wait for each other.

use mech_runtime::mechanism;

// A Stephenson III linkage driven at its second ground pivot: five joints wait for each other.
mechanism! {
    struct NotSequential;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); point q = (6.0, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); point top = (1.5, 1.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }
    link rod { point left = (0.0, 0.0); point right = (4.0, 0.0); }
    link lever { point shaft = (0.0, 0.0); point pin = (2.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);
    joint e = revolute(coupler.top, rod.left);
    joint f = revolute(rod.right, lever.pin);
    joint g = revolute(ground.q, lever.shaft);

    motor g;
    start { g = 120 deg; }
}

// Not every joint of a mechanism without a motor would do for one.
mechanism! {
    struct NotSequentialWithoutMotor;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); point q = (6.0, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); point top = (1.5, 1.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }
    link rod { point left = (0.0, 0.0); point right = (4.0, 0.0); }
    link lever { point shaft = (0.0, 0.0); point pin = (2.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);
    joint e = revolute(coupler.top, rod.left);
    joint f = revolute(rod.right, lever.pin);
    joint g = revolute(ground.q, lever.shaft);

    start { coupler near 30 deg; }
}

fn main() {}
