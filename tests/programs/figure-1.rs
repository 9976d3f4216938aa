//! The first figure of the paper: a piston driven through a pair of gears.

use mech_runtime::mechanism;

mechanism! {
    /// A piston driven through a pair of gears.
    pub struct GearedPiston: f64;

    const THROW = 1.0;

    ground {
        point pinion_shaft = (-3.0, 0.0);
        point wheel_shaft = (0.0, 0.0);
        line bore = (0.0, 0.0) -> (1.0, 0.0);
        polygon [(4.0, 0.6), (8.0, 0.6), (8.0, 0.8), (4.0, 0.8)] on plane 0 color 1;
    }
    link pinion { point shaft = (0.0, 0.0); circle (0.0, 0.0) radius 1.0 on plane 2 color 3; }
    link wheel { point shaft = (0.0, 0.0); point pin = (THROW, 0.0); }
    link rod { point big_end = (0.0, 0.0); point small_end = (4.0, 0.0); }
    link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (1.0, 0.0); }

    joint d = revolute(ground.pinion_shaft, pinion.shaft);
    joint e = revolute(ground.wheel_shaft, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 40);
    joint f = revolute(wheel.pin, rod.big_end);
    joint g = revolute(rod.small_end, piston.pin);
    joint h = prismatic(ground.bore, piston.axis);

    motor d;
    start { d = 0 deg; rod near 0 deg; }
}

fn main() {
    let mut m = GearedPiston::new();
    assert!((m.h() - 5.0).abs() < 1e-9);
    // Two turns of the pinion are one of the wheel.
    m.move_to([core::f64::consts::TAU]).expect("it moves");
    assert!((m.h() - 3.0).abs() < 1e-9);
    assert!((m.rod_small_end().x - 3.0).abs() < 1e-9);
    assert_eq!(m.piston().translation.y, 0.0);
}
