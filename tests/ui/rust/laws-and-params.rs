//! The methods of laws and params stay, though the mechanisms are refused.

use mech_runtime::mechanism;

mechanism! {
    struct Crank;
    ground { point o = (0, 0); }
    link crank { point shaft = (0, 0); }
    joint a = revolute(ground.o, crank.shaft);
    motor a = 0.5 + t;
    start { a = 90 deg; }
}

mechanism! {
    struct Bar;
    param length = 2;
    link bar { point end = (length, 0); circle (0, 0) radius 1 on plane length; }
    joint a = revolute(ground, bar) at (0, 0);
    motor a;
}

fn main() {
    let _ = Crank::new().at_time(1.0);
    let mut bar = Bar::new();
    let _ = bar.set_length(4.0);
    let _ = bar.set_params([bar.length()]);
    let _ = bar.params();
}
