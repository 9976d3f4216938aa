//! Each leg lacks a joint: that is said of the part, and names its instances.

use mech_runtime::mechanism;

mechanism! {
    struct Walker;

    part Leg(phase = 0 deg) {
        port frame { point hip = (4, 0.5); }
        port crank { point pin = (1, 0) turned phase; }
        link coupler { point pin = (0, 0); point knee = (3.2, 0); }
        link rocker { point hip = (0, 0); point knee = (0, 2.5); }
        joint pin = revolute(crank.pin, coupler.pin);
        joint hip = revolute(frame.hip, rocker.hip);
    }

    ground { point shaft = (0, 0); }
    link axle { point shaft = (0, 0); }
    joint main = revolute(ground.shaft, axle.shaft);
    motor main;
    use leg[3]: Leg(phase = k * 120 deg) { frame = ground, crank = axle };
}

fn main() {}
