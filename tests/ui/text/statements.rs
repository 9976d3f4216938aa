//! Statements that cannot be read, or are not what is meant.

use mech_runtime::{mechanism, mechanism_part};

// Effects that contradict what a motor does.
mechanism! {
    struct EffectsThatContradict;
    ground { point o = (0, 0); }
    link arm { point shaft = (0, 0); mass 1 at (1, 0); }
    joint a = revolute(ground.o, arm.shaft);
    motor a = 2 * PI * t;
    effects { dynamics; }
}

// Statements without an end.
mechanism! {
    struct ForgottenSemicolons
    const THROW = 1
    link crank { point pin = (THROW, 0) }
    link rod
    joint a = revolute(ground, crank) at (0, 0)
    motor a
    start { a = 0
            crank near 0 }
}

// The line that names the type is missing.
mechanism! {
    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor a;
}

// Two motors on what has one freedom, none on what hangs beside it.
mechanism! {
    struct MotorMisplaced;

    link crank;
    link coupler;
    link rocker;
    link flag;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (0.5, 1.0);
    joint c = revolute(coupler, rocker) at (3.2, 2.0);
    joint d = revolute(ground, rocker) at (3.5, 0.0);
    joint e = revolute(rocker, flag) at (3.3, 1.0);

    motor a;
    motor d;
}

// Every bad statement is reported in one go.
mechanism! {
    struct SeveralBadStatements;

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

// What is written otherwise in other languages.
mechanism! {
    struct WrittenAsElsewhere;
    let x = 2;
    const A: f64 = 1;
    const B = 10 mm;
    const C = 2^2;
    const D = arccos(0.5);
    const E = arctan2(1, 2);
    link crank {
        point pin = (A, 0) -> 30 deg;
        circle (0, 0) radius 1 plane 2;
        circle (0, 0) radius 1 color rot;
        mass 1 kg;
    }
    link rod;
    joint a = revolute(ground, crank, rod);
    joint b = gear(crank, rod, 2);
    joint c = prismatic(ground, rod) at (0, 0) along 30 deg;
    motor a = t % 2;
    motor b, c;
    start { a = 60 degrees; c = 1 rad; }
}

// A part that is kept for other files is read where it stands.
mechanism_part! {
    pub(crate) Rod(length = 1) {
        port crank { point pin = (0, 0); }
        link rod { point pin = (0, 0); point tip = (length 0); }
        join pin = revolute(crank.pin, rod.pin);
    }
}

fn main() {}
