//! Links that nothing holds.

use mech_runtime::mechanism;

// Two links are joined to each other, but not to the ground.
mechanism! {
    struct Disconnected;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }
    link bow { point pin = (0.0, 0.0); }
    link arrow { point pin = (0.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);
    joint e = revolute(bow.pin, arrow.pin);

    motor a;
    start { a = 60 deg; coupler near 30 deg; }
}

// No joint holds a link.
mechanism! {
    struct LooseLink;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }
    link spare { point hole = (0.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor a;
    start { a = 60 deg; coupler near 30 deg; }
}

fn main() {}
