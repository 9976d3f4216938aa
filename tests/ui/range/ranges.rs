//! Motors that do not reach all of their range.

use mech_runtime::mechanism;

// A motor that starts where its range does not reach.
mechanism! {
    struct StartOutsideItsRange;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor a in 90 deg ..= 180 deg;
    start { a = 60 deg; coupler near 30 deg; }
}

mechanism! {
    struct Rocking;

    ground { point a = (0, 0); point d = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler { point a = (0, 0); point b = (2, 0); }
    link rocker { point shaft = (0, 0); point b = (1.5, 0); }

    joint a = revolute(ground.a, crank.shaft);
    joint b = revolute(crank.pin, coupler.a);
    joint c = revolute(coupler.b, rocker.b);
    joint d = revolute(ground.d, rocker.shaft);

    motor a in -50 deg ..= 90 deg;
    start { coupler near 40 deg; }
}

mechanism! {
    struct Stopping;

    ground { point a = (0, 0); point d = (2, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler { point a = (0, 0); point b = (2, 0); }
    link rocker { point shaft = (0, 0); point b = (1, 0); }

    joint a = revolute(ground.a, crank.shaft);
    joint b = revolute(crank.pin, coupler.a);
    joint c = revolute(coupler.b, rocker.b);
    joint d = revolute(ground.d, rocker.shaft);

    motor a in 10 deg ..= 270 deg;
    start { a = 90 deg; rocker near 90 deg; }
    at change points stop;
}

mechanism! {
    struct Iterated;

    ground { point a = (0, 0); point d = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler { point a = (0, 0); point b = (3.5, 0); }
    link rocker { point shaft = (0, 0); point b = (3, 0); }

    joint a = revolute(ground.a, crank.shaft);
    joint b = revolute(crank.pin, coupler.a);
    joint c = revolute(coupler.b, rocker.b);
    joint d = revolute(ground.d, rocker.shaft);

    motor a in 0 deg ..= 360 deg;
    start { coupler near 50 deg; }
    method newton;
}

fn main() {}
