//! What is written otherwise in other languages.

use mech_runtime::mechanism;

mechanism! {
    struct Crank;
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

fn main() {}
