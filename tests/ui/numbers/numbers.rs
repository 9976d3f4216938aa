//! Numbers that a mechanism cannot have.

use mech_runtime::mechanism;

// A number is not finite.
mechanism! {
    struct NumberNotFinite;

    const GAIN = 1.0 / 0.0;
    const HEIGHT = sqrt(-2.0);

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor a;
    start { a = 60 deg; coupler near 30 deg; }
}

// A number is beyond the largest `f32`.
mechanism! {
    struct NumberTooLargeForF32: f32;

    ground { point base = (0.0, 0.0); }
    link arm { point shoulder = (0.0, 0.0); point hand = (1e39, 0.0); }

    joint shoulder = revolute(ground.base, arm.shoulder);

    motor shoulder;
}

// Single precision has no more than seven digits; no way to solve the loop gives nine.
mechanism! {
    struct TooAccurate: f32;
    link crank;
    link coupler;
    link rocker;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
    motor a by 1 deg;
    accuracy 1e-9;
}

fn main() {}
