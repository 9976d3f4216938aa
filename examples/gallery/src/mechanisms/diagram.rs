//! The mechanism of the paper's first figure as a diagram, without any shape.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A piston driven through a pair of gears, with everything that its diagram needs.
    pub struct PistonDiagram;

    ground {
        point pinion_shaft = (-3, 0);
        point wheel_shaft = (0, 0);
        line bore = (0, 0) -> (1, 0);
    }
    link pinion { point shaft = (0, 0); }
    link wheel { point shaft = (0, 0); point pin = (1, 0); }
    link rod { point big_end = (0, 0); point small_end = (4, 0); }
    link piston { point pin = (0, 0); line axis = (0, 0) -> (1, 0); }

    joint d = revolute(ground.pinion_shaft, pinion.shaft);
    joint e = revolute(ground.wheel_shaft, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 40);
    joint f = revolute(wheel.pin, rod.big_end);
    joint g = revolute(rod.small_end, piston.pin);
    joint h = prismatic(ground.bore, piston.axis);

    motor d;
    start { rod near 0 deg; }
    look none;
    effects { acceleration; overlay; }
}

exhibited!(PistonDiagram, "geared-piston-diagram", "diagram.rs", motion);

/// Two turns of the pinion are one of the wheel.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [(phase + phase) * T::TURN]
}
