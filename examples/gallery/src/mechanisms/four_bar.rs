//! The four-bar linkage in its most common form.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A crank-rocker with a triangular coupler.
    pub struct CrankRocker;

    const GROUND_BAR = 4.0;
    const CRANK = 1.0;
    const COUPLER = 3.5;
    const ROCKER = 3.0;

    ground { point crank_shaft = (0.0, 0.0); point rocker_shaft = (GROUND_BAR, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (CRANK, 0.0); }
    link coupler {
        point crank_pin = (0.0, 0.0);
        point rocker_pin = (COUPLER, 0.0);
        point tip = (1.75, 1.5);
    }
    link rocker { point pin = (ROCKER, 0.0); point shaft = (0.0, 0.0); }

    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.crank_pin);
    joint c = revolute(coupler.rocker_pin, rocker.pin);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);
    motor a;
    start { a = 0 deg; rocker near 110 deg; }
    effects { acceleration; overlay; trace coupler.tip 256 color red; }
}

exhibited!(CrankRocker, "four-bar", "four_bar.rs", motion);

/// One turn of the crank.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [phase * T::TURN]
}
