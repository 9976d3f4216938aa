//! A crate without a prelude: the expansion names everything by its full path.
#![no_implicit_prelude]

::mech_runtime::mechanism! {
    /// A piston driven through a pair of gears.
    pub struct GearedPiston;

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

    joint d = revolute(ground.o, pinion.shaft);
    joint e = revolute(ground.p, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 40);
    joint f = revolute(wheel.pin, rod.big_end);
    joint g = revolute(rod.small_end, piston.pin);
    joint h = prismatic(ground.bore, piston.axis);

    motor d;
    start { rod near 0 deg; }
}

::mech_runtime::mechanism! {
    /// By a fixed number of steps.
    pub struct FourBar: f32;

    link crank;
    link coupler;
    link rocker;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (0.5, 0.8);
    joint c = revolute(coupler, rocker) at (3.0, 2.0);
    joint d = revolute(ground, rocker) at (3.5, 0.0);

    motor a;
    method newton(3);
}

fn main() {
    let mut m = GearedPiston::new();
    ::std::assert!(m.move_to([0.3]).is_ok());
    let mut m = FourBar::new();
    ::std::assert!(m.move_to([0.1]).is_ok());
}
