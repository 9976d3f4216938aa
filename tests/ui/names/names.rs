//! Names that are taken, or unknown.

use mech_runtime::mechanism;

// Constants that Rust declares.
const THROW: f64 = 1.0;

mechanism! {
    struct ConstantOfRust;
    link crank { point pin = (THROW, 0); }
    joint a = revolute(ground, crank) at (0, 0);
    motor a = std::f64::consts::PI * t;
}

// A joint takes the name of a link: both would be the same method.
mechanism! {
    struct JointNamedAsALink;

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

// A link takes the name of a method that every mechanism has.
mechanism! {
    struct NameOfAMethod;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link draw { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, draw.shaft);
    joint b = revolute(draw.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor a;
    start { a = 60 deg; coupler near 30 deg; }
}

// A joint names a link that is not declared.
mechanism! {
    struct UnknownLink;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crnk.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor a;
    start { a = 60 deg; coupler near 30 deg; }
}

fn main() {}
