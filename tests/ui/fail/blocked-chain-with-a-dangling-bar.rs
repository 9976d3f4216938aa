//! The input chain is braced and a bar dangles elsewhere: counting sees one freedom and one motor.

use mech_runtime::mechanism;

mechanism! {
    struct Chain;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); point end = (3.0, 0.0); }
    link brace { point foot = (0.0, 0.0); point head = (3.0, 0.0); }
    link bar { point hook = (0.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);
    joint e = revolute(ground.o, brace.foot);
    joint f = revolute(rocker.end, brace.head);
    joint g = revolute(coupler.right, bar.hook);

    motor a;
    start { a = 60 deg; coupler near 30 deg; }
}

fn main() {}
