//! A belt over a wheel of negative size, a pinion of none, a wheel with no teeth.

use mech_runtime::mechanism;

mechanism! {
    struct Wheels;

    ground { point o = (0.0, 0.0); point p = (3.0, 0.0); line bed = (0.0, 1.0) -> (1.0, 0.0); }
    link driver { point shaft = (0.0, 0.0); }
    link driven { point shaft = (0.0, 0.0); }
    link bar { line axis = (0.0, 0.0) -> (1.0, 0.0); }

    joint a = revolute(ground.o, driver.shaft);
    joint b = revolute(ground.p, driven.shaft);
    joint c = prismatic(ground.bed, bar.axis);
    joint strap = belt(driver, driven, 1.0 : -2.0);
    joint teeth = rack(driver, bar, radius 0);
    joint mesh = gear(driver, driven, 0 : 20);

    motor a;
}

fn main() {}
