//! Attributes that are not taken.

use mech_runtime::mechanism;

// The struct is `Clone`, `Copy`, `Debug`, `Default` and `PartialEq` already.
mechanism! {
    #[derive(Clone)]
    struct DerivedTwice;

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

// Only the struct takes doc comments.
mechanism! {
    struct DocCommentOnALink;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    /// Turned by hand.
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

fn main() {}
