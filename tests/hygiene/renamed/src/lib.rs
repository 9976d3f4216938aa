//! A crate that knows the runtime by another name, and has no standard library.
#![no_std]

mechanics::mechanism! {
    /// A pair of gears, a piston, and an arm: every kind of code that is generated.
    pub struct Machine: f32;

    ground {
        point o = (-3.0, 0.0);
        point p = (0.0, 0.0);
        line bore = (0.0, 0.0) -> (1.0, 0.0);
        polygon [(4.0, 0.6), (8.0, 0.6), (8.0, 0.8)];
    }
    link pinion { point shaft = (0.0, 0.0); circle (0.0, 0.0) radius 1.0; }
    link wheel { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link rod { point big_end = (0.0, 0.0); point small_end = (4.0, 0.0); }
    link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (1.0, 0.0); }
    link hand { point wrist = (0.0, 0.0); }

    joint d = revolute(ground.o, pinion.shaft);
    joint e = revolute(ground.p, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 40);
    joint f = revolute(wheel.pin, rod.big_end);
    joint g = revolute(rod.small_end, piston.pin);
    joint h = prismatic(ground.bore, piston.axis);
    joint wrist = revolute(piston.pin, hand.wrist);

    motor d;
    motor wrist;
    start { rod near 0 deg; }
}
