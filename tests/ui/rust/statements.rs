//! Statements that cannot be read: each is reported at its own place.

use mech_runtime::{mechanism, mechanism_part};

// Constants that Rust declares.
const THROW: f64 = 1.0;

mechanism! {
    struct ConstantOfRust;
    link crank { point pin = (THROW, 0); }
    joint a = revolute(ground, crank) at (0, 0);
    motor a = std::f64::consts::PI * t;
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
