//! Figure 1 of the paper: a piston driven through a pair of gears.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A piston driven through a pair of gears: figure 1 of the paper.
    pub struct GearedPiston;
    look machine;

    const THROW = 1.0; // of the crank pin on the wheel
    const ROD = 4.0;

    ground {
        point pinion_shaft = (-3.0, 0.0);
        point wheel_shaft = (0.0, 0.0);
        line bore = (0.0, 0.0) -> (1.0, 0.0);
        stand (-3.0, 0.0) height 2.6;
        stand (0.0, 0.0) height 2.6;
        polygon [(2.35, -0.9), (6.1, -0.9), (6.1, 0.9), (2.35, 0.9)] color ground dark;
        polygon [(2.39, -0.86), (6.06, -0.86), (6.06, 0.86), (2.39, 0.86)];
        polygon [(2.35, -0.64), (5.8, -0.64), (5.8, 0.64), (2.35, 0.64)] color hatch;
    }
    link pinion { point shaft = (0.0, 0.0); }
    link wheel { point shaft = (0.0, 0.0); point pin = (THROW, 0.0); }
    link rod { point big_end = (0.0, 0.0); point small_end = (ROD, 0.0); }
    link piston {
        point pin = (0.0, 0.0);
        line axis = (0.0, 0.0) -> (1.0, 0.0);
        polygon [(-0.5, -0.6), (0.7, -0.6), (0.7, 0.6), (-0.5, 0.6)] on plane 1 color red;
        polygon [(0.34, -0.6), (0.4, -0.6), (0.4, 0.6), (0.34, 0.6)] on plane 1 color red dark;
        polygon [(0.5, -0.6), (0.56, -0.6), (0.56, 0.6), (0.5, 0.6)] on plane 1 color red dark;
    }

    joint d = revolute(ground.pinion_shaft, pinion.shaft);
    joint e = revolute(ground.wheel_shaft, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 40);
    joint f = revolute(wheel.pin, rod.big_end);
    joint g = revolute(rod.small_end, piston.pin);
    joint h = prismatic(ground.bore, piston.axis);
    motor d;
    start { d = 0 deg; rod near 0 deg; }
    effects { acceleration; overlay; }
}

exhibited!(GearedPiston, "geared-piston", "geared_piston.rs", motion);

/// Two turns of the pinion are one of the wheel.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [(phase + phase) * T::TURN]
}
